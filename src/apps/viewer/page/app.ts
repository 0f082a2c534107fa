import { Changes } from "./changes";
import { Display } from "./display";
import type { Frame } from "./frame";
import type { History, Integrator, Note, Pixel, Saved, State, Welcome } from "./protocol";
import { Signal } from "./signal";
import { Socket } from "./socket";
import { View } from "./view";

/// State and signals that the parts of the page share.
export class App {
  readonly socket = new Socket();
  readonly changes = new Changes(this.socket);
  readonly display = new Display();
  readonly view = new View();

  welcome: Welcome | null = null;
  state: State | null = null;
  /// The newest that has come.
  frame: Frame | null = null;
  /// Name of the layer that was asked for.
  layer = "";

  readonly welcomed = new Signal<Welcome>();
  readonly stated = new Signal<State>();
  readonly framed = new Signal<Frame>();
  readonly history = new Signal<History>();
  readonly pixel = new Signal<Pixel>();
  readonly saved = new Signal<Saved>();
  readonly note = new Signal<Note>();
  readonly layerChanged = new Signal();

  tell(text: string, level: Note["level"] = "note"): void {
    this.note.emit({ type: "note", level, text });
  }

  showLayer(name: string): void {
    this.layer = name;
    this.socket.send({ type: "layer", name });
    this.layerChanged.emit();
  }

  integrators(): Integrator[] {
    const list = this.welcome?.integrators ?? [];
    return Array.isArray(list) ? list : list.integrators;
  }

  /// A finished picture is shown, of which nothing can be changed.
  isFixed(): boolean {
    return this.welcome !== null && this.integrators().length === 0;
  }
}
