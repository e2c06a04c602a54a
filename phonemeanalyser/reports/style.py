"""How the page looks: light and dark as the desktop asks, light on paper."""

from phonemeanalyser.colours import DARK, LIGHT, Theme

ORANGE = {"light": "#b4560c", "dark": "#f2a65a"}
"""The colour of the second preset; that of the first is the accent."""


def style() -> str:
    """Return the style sheet."""
    return (
        f":root{{color-scheme:light dark;{_colours(LIGHT)}}}\n"
        f"@media (prefers-color-scheme:dark){{:root{{{_colours(DARK)}}}}}\n"
        f"{RULES}@media print{{:root{{color-scheme:light;{_colours(LIGHT)}--window:#ffffff}}{PRINT}}}\n"
    )


def _colours(theme: Theme) -> str:
    values = {
        "window": theme.window, "base": theme.base, "raised": theme.raised, "text": theme.text, "faint": theme.faint,
        "line": theme.line, "good": theme.good, "bad": theme.bad, "a": theme.accent, "b": ORANGE[theme.name],
        "on": theme.on_colour,
    }  # fmt: skip
    return "".join(f"--{name}:{value};" for name, value in values.items())


PRINT = """
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}
body{font-size:8.5px;max-width:none;padding:0}
section{border:none;padding:0;margin:16px 0}
h2,h3,section>p{break-after:avoid}
.tiles{gap:8px}
.tile{padding:6px 8px}
.wide{overflow:visible}
th,td{padding:2px 4px}
@page{margin:12mm}
"""

RULES = """
*{box-sizing:border-box}
body{margin:0 auto;max-width:1120px;padding:28px 24px 48px;background:var(--window);color:var(--text);
 font:14px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
h1{font-size:1.75em;line-height:1.2;margin:0 0 6px;font-weight:650}
h2{font-size:1.2em;margin:0 0 4px;font-weight:650}
h3{font-size:1em;margin:18px 0 4px;font-weight:650}
p{margin:0 0 12px}
p.preset{margin:0 0 2px;color:var(--faint)}
p.preset b{color:var(--text)}
.faint{color:var(--faint)}
.a{color:var(--a)}
.b{color:var(--b)}
section{background:var(--base);border:1px solid var(--line);border-radius:10px;padding:18px 20px;margin:18px 0}
.tiles{display:grid;grid-template-columns:repeat(6,1fr);gap:12px;margin:20px 0 0}
.tile{background:var(--base);border:1px solid var(--line);border-radius:10px;padding:12px 14px;break-inside:avoid}
.tile .name{font-size:.86em;color:var(--faint)}
.tile .value{font-size:1.7em;font-weight:650;line-height:1.25;font-variant-numeric:tabular-nums}
.tile .value small{font-size:.5em;font-weight:500;color:var(--faint)}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:20px 28px;align-items:start}
.pair>*{min-width:0}
figure{margin:0 0 6px;break-inside:avoid}
figcaption{margin:0 0 6px}
svg{display:block;width:100%;height:auto;font:11px system-ui,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif}
svg text{fill:var(--text)}
svg .soft{fill:var(--faint)}
svg .mid{text-anchor:middle}
svg .end{text-anchor:end}
svg .on{fill:var(--on)}
svg .fa{fill:var(--a)}
svg .fb{fill:var(--b)}
svg .grid{stroke:var(--line);stroke-width:1}
svg .wrong{fill:var(--bad)}
svg .loud{fill:var(--faint);fill-opacity:.35}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:4px 8px;text-align:right;border-bottom:1px solid var(--line);vertical-align:top;white-space:nowrap}
th{font-weight:600;color:var(--faint);vertical-align:bottom}
thead th{white-space:normal;line-height:1.2}
th:first-child,td:first-child,td.words,th.words{text-align:left;padding-left:0}
tbody:last-child tr:last-child td{border-bottom:none}
tbody:not(:last-child) tr:last-child td{border-bottom:2px solid var(--line)}
tr.sum td{font-weight:650}
td.path,th.path{text-align:left;white-space:normal;overflow-wrap:break-word}
tr{break-inside:avoid}
td span{display:block}
td .less{opacity:.72}
.dot{display:inline-block;flex:none;width:.7em;height:.7em;border-radius:50%;margin-right:.5em}
.key{display:inline-block;width:.8em;height:.8em;border-radius:3px;margin:0 .4em 0 0;vertical-align:-.05em}
.keys span{display:inline-block;margin-right:16px}
dl{display:grid;grid-template-columns:max-content 1fr;gap:4px 16px;margin:0}
dt{font-weight:600}
dd{margin:0;color:var(--faint)}
.note{border-left:3px solid var(--bad);padding-left:10px}
@media screen and (max-width:860px){
 .tiles{grid-template-columns:repeat(3,1fr)}.pair{grid-template-columns:1fr}body{padding:16px 12px}
}
"""
