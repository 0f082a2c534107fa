import type { App } from "./app";
import { find, shortOf } from "./dom";
import { valuesAt } from "./frame";
import type { Pixel } from "./protocol";
import type { Stage } from "./stage";
import type { Tools } from "./tools";
import type { Point } from "./view";

/// Milliseconds between questions while the mouse moves.
const kEvery = 80;
/// After that an answer is not waited for any more.
const kPatience = 3000;

/// The panel of the pixel under the mouse, and the label beside the mouse.
export class Inspector {
  private asked: { point: Point; at: number } | null = null;
  private wanted: Point | null = null;
  private readonly waiting: { point: Point; done: (pixel: Pixel | null) => void }[] = [];
  private timer = 0;

  constructor(private readonly app: App, private readonly stage: Stage, private readonly tools: Tools) {
    tools.hovered.on((point) => this.hover(point));
    app.framed.on(() => this.hover(stage.cursor));
    app.pixel.on((pixel) => this.receive(pixel));
    tools.changed.on(() => (find("tip").hidden = true));
  }

  /// Object, material and values at an image point, or null if the server does not say.
  ask(point: Point): Promise<Pixel | null> {
    const pixel = { x: Math.floor(point.x), y: Math.floor(point.y) };
    if (!this.isInside(pixel)) return Promise.resolve(null);
    return new Promise((resolve) => {
      const entry = {
        point: pixel,
        done: (answer: Pixel | null) => {
          const at = this.waiting.indexOf(entry);
          if (at < 0) return;
          this.waiting.splice(at, 1);
          resolve(answer);
        },
      };
      this.waiting.push(entry);
      setTimeout(() => entry.done(null), kPatience);
      this.app.socket.send({ type: "inspect", ...pixel });
    });
  }

  private isInside({ x, y }: Point): boolean {
    const { frame } = this.app;
    return frame !== null && x >= frame.x && y >= frame.y && x < frame.x + frame.width && y < frame.y + frame.height;
  }

  private hover(point: Point | null): void {
    const isInside = point !== null && this.isInside(point);
    this.wanted = isInside ? point : null;
    find("position").textContent = isInside ? `${point.x}, ${point.y}` : "";
    this.showValue();
    if (isInside) this.askSoon();
    else find("tip").hidden = true;
  }

  /// One question at a time, so that a slow server has no queue of them.
  private askSoon(): void {
    if (this.timer) return;
    const now = performance.now();
    const rest = this.asked ? kPatience - (now - this.asked.at) : 0;
    if (rest > 0) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      if (!this.wanted) return;
      this.asked = { point: this.wanted, at: performance.now() };
      this.app.socket.send({ type: "inspect", x: this.wanted.x, y: this.wanted.y });
    }, kEvery);
  }

  private receive(pixel: Pixel): void {
    for (const { point, done } of [...this.waiting]) {
      if (point.x === pixel.x && point.y === pixel.y) done(pixel);
    }
    const moved = this.asked && this.wanted && (this.wanted.x !== this.asked.point.x || this.wanted.y !== this.asked.point.y);
    this.asked = null;
    if (moved) this.askSoon();
    this.showPixel(pixel);
    this.showTip(pixel);
  }

  private showValue(): void {
    const { frame } = this.app;
    const values = frame && this.wanted ? valuesAt(frame, this.wanted.x, this.wanted.y) : undefined;
    find("value").textContent = values ? values.map(shortOf).join("  ") : "–";
  }

  private showPixel({ object, material, region, samples, error, values }: Pixel): void {
    const facts: [string, string][] = [
      ["object", object?.name || (object ? `number ${object.number}` : "–")],
      ["material", material?.name || (material ? `number ${material.number}` : "–")],
      ["region", region === null ? "–" : shortOf(region)],
      ["samples", samples === null ? "–" : shortOf(samples)],
      ["relative error", error === null ? "–" : ajar.format(error, 3)],
    ];
    const listed = (pairs: [string, string][]) =>
      pairs.flatMap(([name, text]) => [ajar.element("dt", {}, name), ajar.element("dd", {}, text)]);
    find("pixel-facts").replaceChildren(...listed(facts));
    find("pixel-layers").replaceChildren(...listed(
      Object.entries(values).map(([name, list]) => [name || "picture", list.map((x) => shortOf(x ?? NaN)).join("  ")])));
  }

  private showTip({ x, y, object, material }: Pixel): void {
    const tip = find("tip");
    const place = this.stage.mousePlace();
    tip.hidden = this.tools.active.name !== "regions" || !place || !this.wanted || (!object && !material);
    if (tip.hidden || !place) return;
    if (this.wanted && Math.hypot(this.wanted.x - x, this.wanted.y - y) > 60) return;
    const rows = [["object", object], ["material", material]] as const;
    tip.replaceChildren(...rows.flatMap(([kind, thing]) => (thing ? [ajar.element("div", {}, ajar.element("span", {}, `${kind} `), thing.name || String(thing.number), ajar.element("span", {}, this.choiceOf(kind, thing.name)))] : [])));
    const isRight = place.x > this.stage.box.clientWidth - 260;
    tip.style.left = `${place.x + (isRight ? -16 : 16)}px`;
    tip.style.top = `${Math.min(place.y + 16, this.stage.box.clientHeight - 60)}px`;
    tip.style.transform = isRight ? "translateX(-100%)" : "";
  }

  private choiceOf(kind: string, name: string): string {
    const rule = this.app.state?.rules.findLast((one) => one.kind === kind && one.name === name);
    return rule ? ` → ${rule.choice}` : "";
  }
}
