import { button, find } from "./dom";
import { Signal } from "./signal";
import type { Point } from "./view";

export interface Drag {
  /// Image point, and CSS pixels since the last call.
  move(point: Point, dx: number, dy: number): void;
  end(): void;
}

/// A use of the left mouse button on the picture. Points are of the image.
export interface Tool {
  name: string;
  title: string;
  key: string;
  help: string;
  /// Where there is none, dragging moves the picture.
  press?(point: Point, event: PointerEvent): Drag | undefined;
  click?(point: Point, event: PointerEvent): void;
  /// Whether the wheel is taken; else it zooms. A step is half an octave.
  wheel?(steps: number): boolean;
}

const kMove: Tool = { name: "move", title: "Move", key: "v", help: "Drag moves the picture, the wheel zooms" };

/// The tools, one of which is active.
export class Tools {
  readonly list: Tool[] = [kMove];
  readonly changed = new Signal();
  readonly hovered = new Signal<Point | null>();
  active: Tool = kMove;
  private readonly buttons = new Map<string, HTMLButtonElement>();

  add(tool: Tool): void {
    this.list.push(tool);
  }

  /// The same again goes back to moving the picture.
  choose(name: string): void {
    const tool = this.list.find((one) => one.name === name) ?? kMove;
    this.active = tool === this.active ? kMove : tool;
    for (const [other, one] of this.buttons) one.setAttribute("aria-pressed", String(other === this.active.name));
    this.changed.emit();
  }

  show(): void {
    for (const { name, title, key, help } of this.list) {
      const one = button(title, `${help} (${key})`, () => this.choose(name), { id: `tool-${name}`, "aria-pressed": String(name === "move") });
      this.buttons.set(name, one);
      find("tools").append(one);
    }
    this.changed.emit();
  }
}
