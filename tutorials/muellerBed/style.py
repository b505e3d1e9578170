"""style.py -- how the pictures of the tutorials look: colours that people with any colour vision
can tell apart (Okabe and Ito 2008), fonts, and small files.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import io

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt         # noqa: E402

OURS, REFERENCE, OTHER = "#d55e00", "#0072b2", "#009e73"
COLOURS = [OURS, REFERENCE, OTHER, "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
SPEEDS = plt.get_cmap("YlOrBr")         # a quantity from 0
SIGNED = plt.get_cmap("RdYlBu_r")       # one with a sign

plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False,
                     "axes.grid": True, "grid.alpha": 0.25, "savefig.bbox": "tight",
                     "savefig.dpi": 130, "legend.frameon": False, "legend.fontsize": 8,
                     "axes.prop_cycle": plt.cycler(color=COLOURS)})


def image(figure, **options):
    """The figure as an image of at most 256 colours, which makes files three times smaller."""
    from PIL import Image
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", **options)
    return Image.open(buffer).convert("RGB").quantize(256)


def save(figure, path, **options):
    """Write the figure as a PNG file and close it."""
    image(figure, **options).save(path, optimize=True)
    plt.close(figure)
