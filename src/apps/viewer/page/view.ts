import { Signal } from "./signal";

const kLargestZoom = 256;

export interface Point {
  x: number;
  y: number;
}

/// Where an image lies on the canvas: device pixels per image pixel, and its left upper corner in device pixels.
export interface Place {
  zoom: number;
  left: number;
  top: number;
  ratio: number;
}

/// Zoom and place of the picture. Points of the window are CSS pixels from the picture's corner.
export class View {
  readonly changed = new Signal();
  /// Device pixels per CSS pixel.
  ratio = 1;
  private image = { width: 1, height: 1 };
  private canvas = { width: 1, height: 1 };
  private zoom = 0; // 0: fit
  private centre: Point = { x: 0, y: 0 };

  setImage(width: number, height: number): void {
    if (this.image.width === width && this.image.height === height) return;
    this.image = { width, height };
    this.fit();
  }

  setCanvas(width: number, height: number, ratio: number): void {
    this.canvas = { width, height };
    this.ratio = ratio;
    this.changed.emit();
  }

  place(): Place {
    const { image, canvas } = this;
    const fits = this.zoom === 0;
    const zoom = fits ? this.fitZoom() : this.zoom;
    const { x, y } = fits ? { x: image.width / 2, y: image.height / 2 } : this.centre;
    // Whole device pixels, so that image pixels of a whole size are sharp.
    return { zoom, left: Math.round(canvas.width / 2 - x * zoom), top: Math.round(canvas.height / 2 - y * zoom), ratio: this.ratio };
  }

  imagePoint({ x, y }: Point): Point {
    const { zoom, left, top } = this.place();
    return { x: (x * this.ratio - left) / zoom, y: (y * this.ratio - top) / zoom };
  }

  fit(): void {
    this.zoom = 0;
    this.changed.emit();
  }

  /// One device pixel for each of the image.
  toPixels(at?: Point): void {
    this.zoomTo(1, at);
  }

  /// Zooms so that the image point under `at` stays there.
  zoomBy(factor: number, at?: Point): void {
    this.zoomTo(this.place().zoom * factor, at);
  }

  pan(dx: number, dy: number): void {
    const { zoom, left, top } = this.place();
    const x = (this.canvas.width / 2 - left - dx * this.ratio) / zoom;
    const y = (this.canvas.height / 2 - top - dy * this.ratio) / zoom;
    this.lookAt(zoom, x, y);
  }

  private fitZoom(): number {
    const { image, canvas } = this;
    return Math.min(canvas.width / image.width, canvas.height / image.height, kLargestZoom);
  }

  private zoomTo(zoom: number, at?: Point): void {
    const { canvas, ratio } = this;
    const place = at ?? { x: canvas.width / ratio / 2, y: canvas.height / ratio / 2 };
    const point = this.imagePoint(place);
    const next = ajar.clamp(zoom, Math.min(this.fitZoom(), 1) / 4, kLargestZoom);
    this.lookAt(next, point.x - (place.x * ratio - canvas.width / 2) / next, point.y - (place.y * ratio - canvas.height / 2) / next);
  }

  private lookAt(zoom: number, x: number, y: number): void {
    this.zoom = zoom;
    this.centre = { x: ajar.clamp(x, 0, this.image.width), y: ajar.clamp(y, 0, this.image.height) };
    this.changed.emit();
  }
}
