// formulas.js -- KaTeX renders the elements of class math: div displayed, span in the line.
// SPDX-License-Identifier: GPL-3.0-or-later
document.addEventListener("DOMContentLoaded", () => {
    for (const element of document.querySelectorAll(".math")) {
        katex.render(element.textContent, element, { displayMode: element.tagName === "DIV", throwOnError: false });
    }
});
