// What lies over the picture: thumbnails while pixels load, the pixel grid and numbers, frames of insets.
"use strict";
{
  const kGridSize = 14; // CSS pixels per image pixel from which the grid is drawn
  const kNumberSize = 58; // the same for numbers
  const thumbnails = new Map();

  /// Okabe & Ito's colours for insets and series: told apart by the colour-blind, and on dark and light.
  ajar.palette = ["#e69f00", "#56b4e9", "#009e73", "#cc79a7", "#d55e00", "#0072b2", "#f0e442", "#999999"];

  ajar.thumbnailOf = (image) => {
    if (!thumbnails.has(image.index)) {
      const picture = new Image();
      picture.onload = () => ajar.redraw();
      picture.src = `data/${image.thumbnail}`;
      thumbnails.set(image.index, picture);
    }
    return thumbnails.get(image.index);
  };

  const drawThumbnail = (context, image, view) => {
    const picture = ajar.thumbnailOf(image);
    if (!picture.complete || picture.naturalWidth === 0) return;
    context.drawImage(picture, view.left, view.top, view.zoom * image.width, view.zoom * image.height);
  };

  /// Image pixels that columns [left, right) of the canvas show.
  const visible = (canvas, image, view, left, right) => ({
    x0: Math.max(0, Math.floor((left - view.left) / view.zoom)),
    x1: Math.min(image.width, Math.ceil((right - view.left) / view.zoom)),
    y0: Math.max(0, Math.floor(-view.top / view.zoom)),
    y1: Math.min(image.height, Math.ceil((canvas.height - view.top) / view.zoom)),
  });

  const drawGrid = (context, { x0, x1, y0, y1 }, view) => {
    context.beginPath();
    for (let x = x0; x <= x1; ++x) {
      context.moveTo(view.left + x * view.zoom, view.top + y0 * view.zoom);
      context.lineTo(view.left + x * view.zoom, view.top + y1 * view.zoom);
    }
    for (let y = y0; y <= y1; ++y) {
      context.moveTo(view.left + x0 * view.zoom, view.top + y * view.zoom);
      context.lineTo(view.left + x1 * view.zoom, view.top + y * view.zoom);
    }
    context.strokeStyle = "rgb(128 128 128 / 45%)";
    context.lineWidth = 1;
    context.stroke();
  };

  const linesOf = (entry, reference, index) => {
    if (ajar.state.map !== "colour") return [ajar.format(ajar.errorAt(entry, reference, index, ajar.state.map), 3)];
    const value = ajar.valueAt(entry, index);
    return (entry.channels === 1 ? value.slice(0, 1) : value).map((x) => ajar.format(x, 3));
  };

  const drawNumbers = (context, entry, reference, { x0, x1, y0, y1 }, view) => {
    const height = Math.min(view.zoom / 5, 15 * view.ratio);
    context.font = `${height}px ui-monospace, monospace`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (let y = y0; y < y1; ++y) {
      for (let x = x0; x < x1; ++x) {
        const index = y * entry.width + x;
        const [r, g, b] = ajar.shade(entry, reference, index, ajar.state);
        context.fillStyle = 0.3 * r + 0.6 * g + 0.1 * b > 0.5 ? "#000" : "#fff";
        const lines = linesOf(entry, reference, index);
        lines.forEach((line, i) => {
          const row = view.top + (y + 0.5) * view.zoom + (i - (lines.length - 1) / 2) * 1.25 * height;
          context.fillText(line, view.left + (x + 0.5) * view.zoom, row);
        });
      }
    }
  };

  const drawInsetFrames = (context, view) => {
    ajar.state.insets.forEach(({ x, y, size }, i) => {
      const box = [view.left + x * view.zoom, view.top + y * view.zoom, size * view.zoom, size * view.zoom];
      context.strokeStyle = "rgb(0 0 0 / 70%)";
      context.lineWidth = 4 * view.ratio;
      context.strokeRect(...box);
      context.strokeStyle = ajar.palette[i];
      context.lineWidth = 2 * view.ratio;
      context.strokeRect(...box);
      const knob = 4 * view.ratio;
      context.fillStyle = ajar.palette[i];
      context.fillRect(box[0] + box[2] - knob, box[1] + box[3] - knob, 2 * knob, 2 * knob);
    });
  };

  const drawSide = (canvas, context, view, { image, left, right, drawn }) => {
    if (!drawn) {
      if (ajar.state.map === "colour" && ajar.state.layer === image.layers[0].name) drawThumbnail(context, image, view);
      return;
    }
    if (view.zoom < kGridSize * view.ratio) return;
    const area = visible(canvas, image, view, left, right);
    drawGrid(context, area, view);
    if (view.zoom < kNumberSize * view.ratio) return;
    const reference = ajar.state.map === "colour" ? undefined : ajar.pixels.get(ajar.referenceImage(), ajar.state.layer);
    drawNumbers(context, ajar.pixels.get(image, ajar.state.layer), reference, area, view);
  };

  /// `sides`: {image, left, right, drawn}, columns of the canvas.
  ajar.drawOverlay = (canvas, view, sides) => {
    const context = canvas.getContext("2d");
    context.clearRect(0, 0, canvas.width, canvas.height);
    for (const side of sides) {
      context.save();
      context.beginPath();
      context.rect(side.left, 0, side.right - side.left, canvas.height);
      context.clip();
      drawSide(canvas, context, view, side);
      context.restore();
    }
    drawInsetFrames(context, view);
  };
}
