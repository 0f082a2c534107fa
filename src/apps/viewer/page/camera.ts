import type { App } from "./app";
import { find, labelled, numberInput, plain, showValue } from "./dom";
import type { Inspector } from "./inspector";
import { dollied, focalDistance, orbited, reaching, walked } from "./pose";
import type { CameraPose, State } from "./protocol";
import type { Drag, Tools } from "./tools";
import type { Point } from "./view";

/// Milliseconds between poses that are sent while the camera moves.
const kEvery = 50;
/// Until the server's states are of the pose that was sent last.
const kSettle = 1000;
/// After the last step of the wheel the movement has ended.
const kWheelEnds = 300;
/// Shares of the distance to the target, per second.
const kWalk = 0.6;
const kRadiansPerPixel = 0.006;

const kWalkKeys: Record<string, [number, number, number]> = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyD: [0, 1, 0],
  KeyA: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

/// The camera: moved by mouse and keys, and by numbers.
export class Camera {
  private pose: CameraPose | null = null;
  /// Distance of what is in the middle of the picture, until a pose with it is sent: scenes name no target, or one in the air.
  private reach: number | null = null;
  private sentAt = -Infinity;
  private timer = 0;
  private wheelTimer = 0;
  private readonly held = new Set<string>();
  private walkedAt = 0;
  private isFast = false;
  private readonly inputs = new Map<string, HTMLInputElement>();

  constructor(private readonly app: App, private readonly tools: Tools, private readonly inspector: Inspector) {
    tools.add({
      name: "camera",
      title: "Camera",
      key: "c",
      help: "Drag turns about the target, the wheel goes nearer, W A S D and page up, page down walk",
      press: () => this.orbit(),
      wheel: (steps) => this.dolly(steps),
    });
    tools.add({
      name: "focus",
      title: "Focus",
      key: "o",
      help: "Click what is to be sharp",
      click: (point) => void this.focus(point),
    });
    app.stated.on((state) => this.take(state));
    tools.changed.on(() => {
      this.stopWalking();
      if (tools.active.name === "camera") void this.aim();
    });
    addEventListener("blur", () => this.stopWalking());
    this.build();
  }

  /// Whether the key walks. To be asked before shortcuts, some of which are the same keys.
  key(event: KeyboardEvent): boolean {
    const isUp = event.type === "keyup";
    this.isFast = event.shiftKey;
    if (!(event.code in kWalkKeys) || (!isUp && (this.tools.active.name !== "camera" || !this.pose))) return false;
    if (isUp) {
      const wasHeld = this.held.delete(event.code);
      if (wasHeld && this.held.size === 0) this.send(false);
      return wasHeld;
    }
    if (this.held.size === 0) {
      this.walkedAt = performance.now();
      requestAnimationFrame(() => this.walk());
    }
    this.held.add(event.code);
    return true;
  }

  private walk(): void {
    if (this.held.size === 0 || !this.pose) return;
    const now = performance.now();
    const share = kWalk * (this.isFast ? 3 : 1) * Math.min((now - this.walkedAt) / 1000, 0.1);
    this.walkedAt = now;
    for (const code of this.held) {
      const [ahead, right, up] = kWalkKeys[code]!;
      this.pose = walked(this.pose, share * ahead, share * right, share * up);
    }
    this.sendSoon();
    requestAnimationFrame(() => this.walk());
  }

  private stopWalking(): void {
    if (this.held.size === 0) return;
    this.held.clear();
    this.send(false);
  }

  private async aim(): Promise<void> {
    const { state } = this.app;
    if (!state) return;
    const pixel = await this.inspector.ask({ x: state.width / 2, y: state.height / 2 });
    const depth = pixel?.values.depth?.[0];
    if (!depth || !Number.isFinite(depth) || !this.pose || this.timer) return;
    this.reach = depth;
    this.pose = reaching(this.pose, depth);
    this.show();
  }

  private orbit(): Drag | undefined {
    if (!this.pose) return undefined;
    let hasMoved = false;
    return {
      move: (_, dx, dy) => {
        if (!this.pose) return;
        hasMoved = true;
        this.pose = orbited(this.pose, kRadiansPerPixel * dx, kRadiansPerPixel * dy);
        this.sendSoon();
      },
      end: () => hasMoved && this.send(false),
    };
  }

  private dolly(steps: number): boolean {
    if (!this.pose) return false;
    this.pose = dollied(this.pose, 1.25 ** steps);
    this.sendSoon();
    clearTimeout(this.wheelTimer);
    this.wheelTimer = window.setTimeout(() => this.send(false), kWheelEnds);
    return true;
  }

  private async focus(point: Point): Promise<void> {
    const pixel = await this.inspector.ask(point);
    const depth = pixel?.values.depth?.[0];
    const { state } = this.app;
    if (!this.pose || !pixel || !state) return;
    if (!depth || !Number.isFinite(depth)) {
      this.app.tell(depth === undefined ? "This picture has no layer depth, which focusing needs." : "There is nothing to focus on here.");
      return;
    }
    const distance = focalDistance(this.pose, state.width, state.height, pixel.x, pixel.y, depth);
    this.change({ focal_distance: distance });
    const note = this.pose.lens_radius > 0 ? "" : " The lens radius is 0, so all is sharp: give it one in the panel Camera.";
    this.app.tell(`Focus at ${ajar.format(distance)}.${note}`);
  }

  private change(change: Partial<CameraPose>): void {
    if (!this.pose) return;
    this.pose = { ...this.pose, ...change };
    this.send(false);
  }

  private sendSoon(): void {
    if (this.timer) return;
    this.timer = window.setTimeout(() => this.send(true), kEvery);
  }

  private send(moving: boolean): void {
    clearTimeout(this.timer);
    this.timer = 0;
    if (!this.pose) return;
    this.sentAt = performance.now();
    this.reach = null;
    this.app.changes.send({ type: "camera", ...this.pose, moving });
    this.show();
  }

  private take({ camera }: State): void {
    if (!camera || this.timer || this.held.size > 0 || performance.now() - this.sentAt < kSettle) return;
    this.pose = this.reach === null ? camera : reaching(camera, this.reach);
    this.show();
  }

  private build(): void {
    const panel = find("camera");
    for (const name of ["position", "target", "up"] as const) {
      const inputs = [0, 1, 2].map((axis) => {
        const input = numberInput({ "aria-label": `${name}, ${"xyz"[axis]}` }, (value) => {
          if (value === null || !this.pose) return;
          const vector = this.pose[name].slice() as CameraPose["position"];
          vector[axis] = value;
          this.change({ [name]: vector });
        });
        this.inputs.set(`${name}.${axis}`, input);
        return input;
      });
      panel.append(ajar.element("div", { class: "field vector" }, ajar.element("span", { class: "field-name" }, name), ajar.element("span", { class: "triple" }, ...inputs)));
    }
    const numbers = [
      ["fov", "Field of view", "°", { min: 0.1, max: 179 }, "degrees, of the shorter side"],
      ["lens_radius", "Lens radius", "", { min: 0 }, "0: all is sharp"],
      ["focal_distance", "Focal distance", "", { min: 0 }, "along the axis; the focus tool (o) sets it by a click"],
    ] as const;
    for (const [name, title, unit, limits, help] of numbers) {
      const input = numberInput(limits, (value) => value !== null && this.change({ [name]: value }));
      this.inputs.set(name, input);
      panel.append(labelled(title, input, help, unit));
    }
  }

  private show(): void {
    const { pose } = this;
    if (!pose) return;
    for (const [key, input] of this.inputs) {
      const [name = "", axis] = key.split(".");
      const value = pose[name as keyof CameraPose];
      showValue(input, plain(Array.isArray(value) ? value[Number(axis)] ?? 0 : value, 4));
    }
  }
}
