import type { App } from "./app";
import { button, find, numberInput, showValue } from "./dom";
import { wholeWindow } from "./frame";
import type { State, Window } from "./protocol";
import type { Stage } from "./stage";
import type { Drag, Tools } from "./tools";
import type { Place, Point } from "./view";

const kEdges = ["left", "top", "right", "bottom"] as const;

/// The part of the picture that is rendered: drawn with the mouse, or four numbers.
export class Crop {
  private readonly inputs: HTMLInputElement[];
  private drawn: Window | null = null;

  constructor(private readonly app: App, private readonly stage: Stage, private readonly tools: Tools) {
    tools.add({
      name: "crop",
      title: "Crop",
      key: "k",
      help: "Draw the part that is rendered; a click takes it away",
      press: (point) => this.press(point),
    });
    this.inputs = kEdges.map((name) => numberInput({ min: 0, step: 1, "aria-label": name, title: name }, () => this.sendNumbers()));
    find("crop").append(ajar.element("div", { class: "field" }, ajar.element("span", { class: "field-name" }, "Crop"),
      ajar.element("span", { class: "four" }, ...this.inputs)),
      button("Whole picture", "Render all of it", () => this.send(null), { class: "small", id: "no-crop" }));
    app.stated.on((state) => this.take(state));
    stage.paint((context, place) => this.paint(context, place));
  }

  private press(start: Point): Drag | undefined {
    const { state } = this.app;
    if (!state) return undefined;
    return {
      move: (point) => {
        const [x, y] = [[start.x, point.x], [start.y, point.y]].map((pair) => pair.sort((a, b) => a - b)) as [[number, number], [number, number]];
        const inside = (value: number, side: number) => ajar.clamp(value, 0, side);
        this.drawn = [
          inside(Math.floor(x[0]), state.width), inside(Math.floor(y[0]), state.height),
          inside(Math.ceil(x[1]), state.width), inside(Math.ceil(y[1]), state.height),
        ];
        this.stage.redraw();
      },
      end: () => {
        const { drawn } = this;
        this.drawn = null;
        const isLarge = drawn && drawn[2] - drawn[0] > 2 && drawn[3] - drawn[1] > 2;
        if (isLarge) this.send(drawn);
        else if (!drawn) this.send(null);
        this.stage.redraw();
      },
    };
  }

  private sendNumbers(): void {
    const window = this.inputs.map((input) => input.valueAsNumber) as Window;
    const isOne = window.every(Number.isInteger) && window[0] < window[2] && window[1] < window[3];
    if (isOne) this.send(window);
    else this.app.tell("A crop is left and top edge, and the edges right and below, which are larger.", "warning");
  }

  private send(window: Window | null): void {
    const { state } = this.app;
    if (!state || JSON.stringify(this.windowOf(state)) === JSON.stringify(window ?? wholeWindow(state.width, state.height))) return;
    this.app.changes.send({ type: "crop", window });
  }

  private windowOf({ crop, width, height }: State): Window {
    return crop ?? wholeWindow(width, height);
  }

  private take(state: State): void {
    if (this.inputs.some((input) => input === document.activeElement)) return;
    this.windowOf(state).forEach((edge, i) => showValue(this.inputs[i]!, String(edge)));
  }

  private paint(context: CanvasRenderingContext2D, { zoom, left, top, ratio }: Place): void {
    const { state } = this.app;
    const window = this.drawn ?? (this.tools.active.name === "crop" && state ? this.windowOf(state) : null);
    if (!window) return;
    const box = [left + window[0] * zoom, top + window[1] * zoom, (window[2] - window[0]) * zoom, (window[3] - window[1]) * zoom] as const;
    for (const [colour, width] of [["rgb(0 0 0 / 70%)", 4], ["#56b4e9", 2]] as const) {
      context.strokeStyle = colour;
      context.lineWidth = width * ratio;
      context.strokeRect(...box);
    }
  }
}
