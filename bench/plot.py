"""Draws line charts as SVG for light and dark pages: panels side by side with logarithmic or linear axes."""
import math
from dataclasses import dataclass, field
from html import escape

WIDTH, HEIGHT = 330, 260  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 58, 14, 34, 44  # its margins
STYLE = """<style>
text { font: 12px system-ui, sans-serif; fill: #333 } .title { font-weight: 600 } .tick { font-size: 11px }
.frame { stroke: #888; fill: none } .grid { stroke: #8884 } .line { fill: none; stroke-width: 2 }
.c0 { stroke: #0a66c2; fill: #0a66c2 } .c1 { stroke: #c2410c; fill: #c2410c }
.c2 { stroke: #15803d; fill: #15803d } .c3 { stroke: #7c3aed; fill: #7c3aed }
text.c0, text.c1, text.c2, text.c3 { stroke: none } .ideal { stroke-dasharray: 4 4 }
@media (prefers-color-scheme: dark) { text { fill: #ddd }
.c0 { stroke: #60a5fa; fill: #60a5fa } .c1 { stroke: #fb923c; fill: #fb923c }
.c2 { stroke: #4ade80; fill: #4ade80 } .c3 { stroke: #c4b5fd; fill: #c4b5fd } }
</style>"""


@dataclass
class Panel:
    title: str
    x_label: str
    y_label: str
    series: dict  # name -> [(x, y)]
    log_x: bool = True
    log_y: bool = True
    dashed: set = field(default_factory=set)  # names of series drawn as a guide


class Axis:
    def __init__(self, values, log, start, end):
        self.log = log
        low, high = min(values), max(values)
        if log:
            low = math.floor(math.log10(low) + 0.01)
            high = max(math.ceil(math.log10(high) - 0.01), low + 1)
        else:
            low, high = 0, high * 1.05
        self.low, self.high, self.start, self.end = low, high, start, end

    def place(self, value):
        value = math.log10(value) if self.log else value
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self):
        if self.log:
            step = max(1, round((self.high - self.low) / 6))
            return [10.0 ** power for power in range(self.low, self.high + 1, step)]
        step = 10 ** math.floor(math.log10(self.high / 2))
        step *= next((factor for factor in (1, 2, 5) if self.high / (step * factor) <= 5), 10)
        return [step * i for i in range(int(self.high / step) + 1)]


def short(value):
    """1000 as 1k, 1e7 as 10M."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:g}{letter}"
    return f"{value:g}"


def panel_svg(panel, offset):
    points = [point for series in panel.series.values() for point in series]
    x_axis = Axis([x for x, _ in points], panel.log_x, LEFT, WIDTH - RIGHT)
    y_axis = Axis([y for _, y in points], panel.log_y, HEIGHT - BOTTOM, TOP)
    yield f'<g transform="translate({offset},0)">'
    for tick in x_axis.ticks():
        x = x_axis.place(tick)
        yield f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}"/>'
        yield (f'<text class="tick" x="{x:.1f}" y="{HEIGHT - BOTTOM + 15}" '
               f'text-anchor="middle">{short(tick)}</text>')
    for tick in y_axis.ticks():
        y = y_axis.place(tick)
        yield f'<line class="grid" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
        yield f'<text class="tick" x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end">{short(tick)}</text>'
    yield (f'<rect class="frame" x="{LEFT}" y="{TOP}" width="{WIDTH - RIGHT - LEFT}" '
           f'height="{HEIGHT - BOTTOM - TOP}"/>'
           f'<text class="title" x="{LEFT}" y="18">{escape(panel.title)}</text>'
           f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" '
           f'text-anchor="middle">{escape(panel.x_label)}</text>'
           f'<text transform="translate(13,{(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">'
           f'{escape(panel.y_label)}</text>')
    for index, (name, series) in enumerate(panel.series.items()):
        places = [(x_axis.place(x), y_axis.place(y)) for x, y in series]
        guide = " ideal" if name in panel.dashed else ""
        yield (f'<polyline class="line c{index % 4}{guide}" style="fill:none" points="' +
               " ".join(f"{x:.1f},{y:.1f}" for x, y in places) + '"/>')
        if not guide:
            yield from (f'<circle class="c{index % 4}" cx="{x:.1f}" cy="{y:.1f}" r="3"/>' for x, y in places)
        yield f'<text class="c{index % 4}" x="{LEFT + 8}" y="{TOP + 16 + 15 * index}">{escape(name)}</text>'
    yield "</g>"


def write_svg(path, panels):
    panels = [panel for panel in panels if any(panel.series.values())]
    if not panels:
        return
    width = WIDTH * len(panels)
    body = "\n".join(line for i, panel in enumerate(panels) for line in panel_svg(panel, i * WIDTH))
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" width="{width}" '
                    f'height="{HEIGHT}">\n{STYLE}\n{body}\n</svg>\n')
