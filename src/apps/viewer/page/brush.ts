import type { App } from "./app";
import { button, find, labelled } from "./dom";
import { encodeMask } from "./frame";
import type { State } from "./protocol";
import type { Stage } from "./stage";
import type { Drag, Tools } from "./tools";
import type { Place, Point } from "./view";

/// Left to the method.
const kNone = 255;
/// Milliseconds in which states may still be of before a stroke.
const kSettle = 1500;

/// Weights painted on the picture, sent after each stroke.
export class Brush {
  private width = 0;
  private height = 0;
  private weights: Uint8Array | null = null;
  private sentAt = -Infinity;
  private isPainting = false;
  /// The weights as colours, as large as the picture.
  private readonly canvas = document.createElement("canvas");
  private readonly size = ajar.element("input", { type: "range", min: 2, max: 200, value: 40, id: "brush-size" });
  private readonly weight = ajar.element("input", { type: "range", min: 0, max: 1, step: 0.05, value: 1, id: "brush-weight" });
  private readonly erases = ajar.element("input", { type: "checkbox", id: "brush-erases" });

  constructor(private readonly app: App, private readonly stage: Stage, private readonly tools: Tools) {
    tools.add({
      name: "brush",
      title: "Brush",
      key: "b",
      help: "Paint where chains render: by the weight in the panel. Shift erases",
      press: (point, event) => this.press(point, event.shiftKey || this.erases.checked),
    });
    const clear = button("Clear", "Take the painted weights away", () => this.set(null));
    const shown = ajar.element("output", { for: "brush-weight" }, "1.00");
    this.weight.addEventListener("input", () => (shown.textContent = this.weight.valueAsNumber.toFixed(2)));
    find("brush").append(
      labelled("Size", this.size, "Diameter in pixels of the picture"),
      ajar.element("div", { class: "inline" }, labelled("Weight", this.weight, "Share of chains: 0 is ordinary Monte Carlo alone, 1 chains alone"), shown),
      ajar.element("div", { class: "inline" },
        ajar.element("label", { title: "Leave it to the method (Shift)" }, this.erases, " erase"), clear, ajar.element("span", { id: "masked", class: "tag", hidden: true }, "painted")),
    );
    app.stated.on((state) => this.take(state));
    stage.paint((context, place) => this.paint(context, place));
    tools.hovered.on(() => tools.active.name === "brush" && stage.redraw());
  }

  private take({ width, height, masked }: State): void {
    find("masked").hidden = !masked;
    const isOther = this.width !== width || this.height !== height;
    const isGone = !masked && !this.isPainting && performance.now() - this.sentAt > kSettle;
    if (this.weights && (isOther || isGone)) this.hold(null);
    this.width = width;
    this.height = height;
  }

  private press(point: Point, erases: boolean): Drag | undefined {
    if (!this.app.state || this.width === 0) return undefined;
    const before = this.weights;
    this.isPainting = true;
    this.weights = before ? before.slice() : new Uint8Array(this.width * this.height).fill(kNone);
    const value = erases ? kNone : Math.round(254 * this.weight.valueAsNumber);
    let last = point;
    this.stroke(point, point, value);
    return {
      move: (to) => {
        this.stroke(last, to, value);
        last = to;
      },
      end: () => {
        this.isPainting = false;
        this.set(this.weights, before);
      },
    };
  }

  private stroke(from: Point, to: Point, value: number): void {
    const { width, height, weights } = this;
    if (!weights) return;
    const radius = Math.max(this.size.valueAsNumber / 2, 0.5);
    const steps = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / Math.max(radius / 3, 1)));
    for (let i = 0; i <= steps; ++i) {
      const x = from.x + ((to.x - from.x) * i) / steps;
      const y = from.y + ((to.y - from.y) * i) / steps;
      for (let row = Math.max(0, Math.floor(y - radius)); row <= Math.min(height - 1, y + radius); ++row) {
        const half = Math.sqrt(Math.max(0, radius ** 2 - (row + 0.5 - y) ** 2));
        const begin = ajar.clamp(Math.round(x - half), 0, width);
        const end = ajar.clamp(Math.round(x + half), 0, width);
        weights.fill(value, row * width + begin, row * width + Math.max(begin, end));
      }
    }
    this.colour();
  }

  private set(weights: Uint8Array | null, before = this.weights): void {
    this.hold(weights);
    this.sentAt = performance.now();
    const local = (held: Uint8Array | null) => () => {
      this.sentAt = performance.now();
      this.hold(held);
    };
    this.app.changes.send(encodeMask(this.width, this.height, weights), { undo: local(before), redo: local(weights) });
  }

  private hold(weights: Uint8Array | null): void {
    this.weights = weights;
    this.colour();
  }

  private colour = ajar.perFrame(() => {
    const { weights, width, height, canvas } = this;
    if (weights && width > 0) {
      canvas.width = width;
      canvas.height = height;
      const image = new ImageData(width, height);
      const bytes = new Uint32Array(image.data.buffer);
      // From blue, ordinary Monte Carlo, to orange, chains; the report's two accents.
      const colours = Uint32Array.from({ length: 256 }, (_, weight) => {
        const t = weight / 254;
        const [r, g, b] = [[86, 230], [180, 159], [233, 0]].map(([low = 0, high = 0]) => Math.round(low + t * (high - low)));
        return weight === kNone ? 0 : ((150 << 24) | (b! << 16) | (g! << 8) | r!) >>> 0;
      });
      for (let i = 0; i < weights.length; ++i) bytes[i] = colours[weights[i]!]!;
      canvas.getContext("2d")?.putImageData(image, 0, 0);
    }
    this.stage.redraw();
  });

  private paint(context: CanvasRenderingContext2D, { zoom, left, top, ratio }: Place): void {
    const isActive = this.tools.active.name === "brush";
    if (this.weights && (isActive || this.tools.active.name === "regions")) {
      context.imageSmoothingEnabled = false;
      context.drawImage(this.canvas, left, top, zoom * this.width, zoom * this.height);
    }
    const mouse = this.stage.mousePlace();
    if (!isActive || !mouse) return;
    for (const [colour, width] of [["#000", 3], ["#fff", 1]] as const) {
      context.beginPath();
      context.arc(mouse.x * ratio, mouse.y * ratio, (zoom * this.size.valueAsNumber) / 2, 0, 2 * Math.PI);
      context.strokeStyle = colour;
      context.lineWidth = width * ratio;
      context.stroke();
    }
  }
}
