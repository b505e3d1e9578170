"""style.py -- the style of all pictures: colours that people with any colour vision can tell apart (Okabe
and Ito 2008), fonts, axes, and small files.

Lines or filled marks in OURS are Suna; measurements are open marks in REFERENCE, with their intervals;
formulas and other codes are thin lines in REFERENCE or GREY. Legends stand beside or below the data.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import io
import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt         # noqa: E402

OURS, REFERENCE, OTHER, GREY = "#d55e00", "#0072b2", "#009e73", "#777777"
COLOURS = [REFERENCE, OURS, OTHER, "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
MARKS = ["o", "s", "^", "D", "v", "P", "X"]
SPEEDS = plt.get_cmap("YlOrBr")         # a quantity from 0
SIGNED = plt.get_cmap("RdYlBu_r")       # one with a sign

MEASURED = {"ls": "", "marker": "o", "ms": 4.5, "mfc": "none", "color": REFERENCE}      # for plot
POINTS = {"ls": "", "capsize": 3, "lw": 1.3, "ms": 5}                                  # for errorbar

plt.rcParams.update({
    "font.size": 10, "axes.labelsize": 10, "axes.titlesize": 10, "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.alpha": 0.25,
    "axes.prop_cycle": plt.cycler(color=COLOURS), "lines.linewidth": 1.6, "lines.markersize": 5,
    "legend.frameon": False, "legend.fontsize": 9, "savefig.bbox": "tight", "savefig.dpi": 130,
    "svg.hashsalt": "suna"})


def panels(number, width=None, height=3.4, across=None, **options):
    """A figure with this many axes in a row, or in rows of `across`: the figure, and a list of them."""
    columns = min(number, across or number)
    rows = -(-number//columns)
    figure, axes = plt.subplots(rows, columns, figsize=(width or 4.2*columns, height*rows), squeeze=False,
                                layout="constrained", **options)
    for rest in axes.flat[number:]:
        rest.axis("off")
    return figure, list(axes.flat[:number])


def shades(number):
    """Colours of an ordered series, light to dark."""
    return [plt.get_cmap("cividis_r")(0.15 + 0.85*k/max(number - 1, 1)) for k in range(number)]


def below(figure, *axes, columns=2, **options):
    """One legend of all these axes below the figure; each label once."""
    entries = {}
    for one in axes or figure.axes:
        for handle, label in zip(*one.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    return figure.legend(entries.values(), entries.keys(), loc="upper center", bbox_to_anchor=(0.5, 0),
                         ncols=columns, **options)


def plain_ticks(axis, values, form="%g"):
    """These ticks on an axis, as plain numbers and without minor ones."""
    axis.set_ticks(list(values), [form % value for value in values])
    axis.set_ticks([], minor=True)


def log_ticks(axis):
    """Ticks at 1, 2 and 5 (or 1 to 9) of each decade of a logarithmic axis that spans less than two."""
    low, high = axis.get_view_interval()
    if high < 100*low:
        first = math.floor(math.log10(low))
        for digits in ((1, 2, 5), range(1, 10)):
            ticks = [d*10.0**k for k in range(first, first + 4) for d in digits if low <= d*10.0**k <= high]
            if len(ticks) > 1:
                break
        plain_ticks(axis, ticks)


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
