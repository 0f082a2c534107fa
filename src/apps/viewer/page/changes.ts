import type { ToServer } from "./protocol";
import type { Socket } from "./socket";

/// The page's own part of a change: texts of inputs, painted weights.
export interface Local {
  undo(): void;
  redo(): void;
}

const kNothing: Local = { undo() {}, redo() {} };

/// Changes that the server can undo, and beside them what the page keeps of each, in the same order.
export class Changes {
  private done: Local[] = [];
  private undone: Local[] = [];
  private isMoving = false;

  constructor(private readonly socket: Socket) {}

  send(message: ToServer | ArrayBuffer, local: Local = kNothing): void {
    // All that a mouse moves from press to release is one change.
    if (!this.isMoving) this.done.push(local);
    this.isMoving = !(message instanceof ArrayBuffer) && message.type === "camera" && message.moving;
    this.undone = [];
    this.socket.send(message);
  }

  undo(): void {
    this.step(this.done, this.undone, "undo");
  }

  redo(): void {
    this.step(this.undone, this.done, "redo");
  }

  /// After a new connection or in a second tab the server may know more changes than the page.
  forget(): void {
    this.done = [];
    this.undone = [];
    this.isMoving = false;
  }

  private step(from: Local[], to: Local[], type: "undo" | "redo"): void {
    const local = from.pop();
    if (local) {
      local[type]();
      to.push(local);
    }
    this.isMoving = false;
    this.socket.send({ type });
  }
}
