import type { App } from "./app";
import { find } from "./dom";
import { rangeOf, type Frame } from "./frame";
import { Renderer } from "./gl";
import type { Snapshots } from "./snapshots";
import type { Tools } from "./tools";
import type { Place, Point } from "./view";

/// Pixels that a mouse may move in a click.
const kClick = 4;

export type Painter = (context: CanvasRenderingContext2D, place: Place) => void;

/// The picture: what is drawn, and where mouse, pen and wheel go.
export class Stage {
  readonly box = find("viewer");
  /// Image pixel under the mouse.
  cursor: Point | null = null;
  /// Number of the newest frame that is on the screen.
  drawn = -1;
  range: [number, number] = [0, 1];

  private readonly canvas = find<HTMLCanvasElement>("picture");
  private readonly overlay = find<HTMLCanvasElement>("overlay");
  private readonly renderer: Renderer;
  private readonly painters: Painter[] = [];
  private pending = -1;
  private mouse: Point | undefined;
  readonly redraw = ajar.perFrame(() => this.drawNow());

  constructor(private readonly app: App, private readonly tools: Tools, private readonly snapshots: Snapshots) {
    this.renderer = new Renderer(this.canvas, () => this.redraw());
    app.framed.on((frame) => this.take(frame));
    app.view.changed.on(() => this.redraw());
    app.display.changed.on(() => this.redraw());
    snapshots.changed.on(() => this.redraw());
    tools.changed.on(() => {
      this.box.dataset.tool = tools.active.name;
      this.redraw();
    });
    new ResizeObserver(() => this.resize()).observe(this.box);
    this.listen();
  }

  /// Paints over the picture after each drawing, in device pixels.
  paint(painter: Painter): void {
    this.painters.push(painter);
  }

  /// Where to zoom from the keyboard.
  mousePlace(): Point | undefined {
    return this.mouse;
  }

  drawNow(): void {
    const { renderer, app, snapshots, canvas } = this;
    const place = app.view.place();
    const { left, right } = snapshots.columns(canvas.width);
    renderer.hold(0, app.frame);
    renderer.hold(1, snapshots.kept?.frame ?? null);
    renderer.clear();
    renderer.draw(1, place, app.display, this.rangeFor(snapshots.kept?.frame), 0, left);
    renderer.draw(0, place, app.display, this.range, left, right);
    this.drawOverlay(place);
    if (this.pending >= 0) {
      this.drawn = this.pending;
      this.pending = -1;
      app.socket.send({ type: "ack", frame: this.drawn });
    }
  }

  /// Bytes on the screen in the middle of an image pixel.
  shown(x: number, y: number): number[] {
    this.drawNow();
    const { zoom, left, top } = this.app.view.place();
    return this.renderer.read(Math.floor(left + (x + 0.5) * zoom), Math.floor(top + (y + 0.5) * zoom));
  }

  /// CSS pixels of the window in the middle of an image pixel.
  windowPlace(x: number, y: number): Point {
    const { zoom, left, top, ratio } = this.app.view.place();
    const box = this.box.getBoundingClientRect();
    return { x: box.left + (left + (x + 0.5) * zoom) / ratio, y: box.top + (top + (y + 0.5) * zoom) / ratio };
  }

  private take(frame: Frame): void {
    this.app.frame = frame;
    this.app.view.setImage(frame.imageWidth, frame.imageHeight);
    this.range = rangeOf(frame);
    this.pending = frame.number;
    this.redraw();
  }

  /// Two pictures of one layer have one scale.
  private rangeFor(kept: Frame | undefined): [number, number] {
    return !kept || kept.layer === this.app.frame?.layer ? this.range : rangeOf(kept);
  }

  private drawOverlay(place: Place): void {
    // On a processor that draws for WebGL too, canvases of the GPU show for seconds what was cleared.
    const context = this.overlay.getContext("2d", { willReadFrequently: true });
    if (!context) return;
    context.clearRect(0, 0, this.overlay.width, this.overlay.height);
    for (const painter of this.painters) {
      context.save();
      painter(context, place);
      context.restore();
    }
  }

  private resize(): void {
    const ratio = devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.overlay]) {
      canvas.width = Math.max(1, Math.round(this.box.clientWidth * ratio));
      canvas.height = Math.max(1, Math.round(this.box.clientHeight * ratio));
    }
    this.app.view.setCanvas(this.canvas.width, this.canvas.height, ratio);
    // At once: a canvas is empty after a change of its size.
    this.drawNow();
  }

  // ---------------------------------------------------------------- mouse and pen

  private listen(): void {
    const { box } = this;
    box.addEventListener("pointerdown", (event) => this.press(event));
    box.addEventListener("pointermove", (event) => this.hover(event));
    box.addEventListener("pointerleave", () => this.leave());
    box.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    box.addEventListener("contextmenu", (event) => event.preventDefault());
    box.addEventListener("dblclick", (event) => {
      if (this.tools.active.name === "move" && event.target instanceof HTMLCanvasElement) this.app.view.fit();
    });
  }

  private placeOf(event: MouseEvent): Point {
    const box = this.box.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private hover(event: PointerEvent): void {
    this.mouse = this.placeOf(event);
    const point = this.app.view.imagePoint(this.mouse);
    this.cursor = { x: Math.floor(point.x), y: Math.floor(point.y) };
    this.tools.hovered.emit(this.cursor);
  }

  private leave(): void {
    this.mouse = undefined;
    this.cursor = null;
    this.tools.hovered.emit(null);
  }

  private wheel(event: WheelEvent): void {
    if (event.target instanceof Element && event.target.closest(".card")) return;
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 40 : 1;
    const steps = (event.deltaY * unit) / 240;
    if (!event.ctrlKey && this.tools.active.wheel?.(steps)) return;
    this.app.view.zoomBy(2 ** -steps, this.placeOf(event));
  }

  private press(event: PointerEvent): void {
    if (!(event.target instanceof HTMLCanvasElement)) return;
    event.preventDefault();
    this.box.focus({ preventScroll: true });
    const { view } = this.app;
    const start = this.placeOf(event);
    const tool = this.tools.active;
    const drag = event.button === 0 ? tool.press?.(view.imagePoint(start), event) : undefined;
    let last = start;
    let isClick = true;
    this.box.setPointerCapture(event.pointerId);
    this.box.classList.add("dragging");
    const move = (moved: PointerEvent) => {
      const place = this.placeOf(moved);
      if (isClick && Math.hypot(place.x - start.x, place.y - start.y) < kClick && !drag) return;
      isClick = false;
      if (drag) drag.move(view.imagePoint(place), place.x - last.x, place.y - last.y);
      else view.pan(place.x - last.x, place.y - last.y);
      last = place;
    };
    const end = (ended: PointerEvent) => {
      this.box.removeEventListener("pointermove", move);
      this.box.removeEventListener("pointerup", end);
      this.box.removeEventListener("pointercancel", end);
      this.box.classList.remove("dragging");
      drag?.end();
      if (isClick && event.button === 0 && ended.type === "pointerup") tool.click?.(view.imagePoint(start), event);
    };
    this.box.addEventListener("pointermove", move);
    this.box.addEventListener("pointerup", end);
    this.box.addEventListener("pointercancel", end);
  }
}
