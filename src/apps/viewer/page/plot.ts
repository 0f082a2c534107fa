import type { App } from "./app";
import { find } from "./dom";

const kWidth = 320;
const kHeight = 190;
const kLeft = 46;
const kBottom = 30;
const kTop = 8;
const kRight = 10;

type Attributes = Record<string, string | number>;

function svg(name: string, attributes: Attributes = {}, text = ""): SVGElement {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, String(value));
  if (text) node.textContent = text;
  return node;
}

/// Powers of ten in the range; with few of them also 2 and 5 times.
function ticksOf(low: number, high: number): number[] {
  const factors = high - low < 1.5 ? [1, 2, 5] : [1];
  const ticks: number[] = [];
  for (let decade = Math.floor(low); decade <= Math.ceil(high); ++decade) {
    for (const factor of factors) {
      const at = decade + Math.log10(factor);
      if (at >= low - 1e-9 && at <= high + 1e-9) ticks.push(factor * 10 ** decade);
    }
  }
  const stride = Math.ceil(ticks.length / 7);
  return ticks.filter((_, i) => i % stride === 0);
}

function rangeOf(values: number[]): [number, number] {
  const [low, high] = [Math.log10(Math.min(...values)), Math.log10(Math.max(...values))];
  const margin = Math.max(0.05 * (high - low), 0.15);
  return [low - margin, high + margin];
}

/// Error against time, both logarithmic. A dashed line falls as 1/√time through the last point.
export class Plot {
  private shown = "";

  constructor(app: App) {
    app.history.on(({ points }) => this.take(points));
  }

  private take(points: [number, number][]): void {
    const usable = points.filter(([seconds, error]) => seconds > 0 && error > 0);
    const key = `${usable.length} ${usable[0]} ${usable.at(-1)}`;
    if (key === this.shown) return;
    this.shown = key;
    const box = find("plot");
    if (usable.length === 0) {
      box.replaceChildren(ajar.element("p", { class: "quiet" }, "No estimate of the error yet."));
      return;
    }
    box.replaceChildren(this.draw(usable));
  }

  private draw(points: [number, number][]): SVGElement {
    const [left, right] = rangeOf(points.map(([seconds]) => seconds));
    const [low, high] = rangeOf(points.map(([, error]) => error));
    const x = (seconds: number) => kLeft + ((Math.log10(seconds) - left) / (right - left)) * (kWidth - kLeft - kRight);
    const y = (error: number) => kTop + ((high - Math.log10(error)) / (high - low)) * (kHeight - kTop - kBottom);
    const last = points.at(-1)!;
    const picture = svg("svg", {
      viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img",
      "aria-label": `Error against time: ${ajar.format(last[1], 3)} after ${ajar.format(last[0], 3)} seconds`,
    });
    for (const tick of ticksOf(left, right)) {
      picture.append(svg("line", { class: "grid", x1: x(tick), x2: x(tick), y1: kTop, y2: kHeight - kBottom }),
        svg("text", { x: x(tick), y: kHeight - kBottom + 13, "text-anchor": "middle" }, shortOf(tick)));
    }
    for (const tick of ticksOf(low, high)) {
      picture.append(svg("line", { class: "grid", x1: kLeft, x2: kWidth - kRight, y1: y(tick), y2: y(tick) }),
        svg("text", { x: kLeft - 4, y: y(tick) + 4, "text-anchor": "end" }, shortOf(tick)));
    }
    picture.append(svg("text", { class: "axis-title", x: (kLeft + kWidth - kRight) / 2, y: kHeight - 3, "text-anchor": "middle" }, "seconds"));
    picture.append(this.guide(last, left, right, low, high, x, y));
    picture.append(svg("polyline", { class: "curve", points: points.map(([seconds, error]) => `${x(seconds).toFixed(1)},${y(error).toFixed(1)}`).join(" ") }));
    picture.append(svg("circle", { class: "mark", cx: x(last[0]), cy: y(last[1]), r: 3.5 }));
    return picture;
  }

  private guide(last: [number, number], left: number, right: number, low: number, high: number, x: (v: number) => number, y: (v: number) => number): SVGElement {
    const [seconds, error] = last.map(Math.log10) as [number, number];
    const at = (time: number) => error - (time - seconds) / 2;
    const begin = Math.max(left, seconds - 2 * (high - error));
    const end = Math.min(right, seconds + 2 * (error - low));
    const line = svg("line", { class: "guide", x1: x(10 ** begin), y1: y(10 ** at(begin)), x2: x(10 ** end), y2: y(10 ** at(end)) });
    line.append(svg("title", {}, "as 1/√time"));
    return line;
  }
}

const shortOf = (value: number): string =>
  value >= 1e-3 && value < 1e5 ? String(Number(value.toPrecision(1))) : value.toExponential(0).replace("e+", "e").replace("-", "−");
