// Draws pictures without WebGL: shades whole images on the processor, keeps a few, lets the browser scale them.
"use strict";
{
  const kKept = 12;

  ajar.makeCanvasRenderer = (canvas) => {
    const context = canvas.getContext("2d");
    const kept = new Map(); // what it shows → canvas

    const shaded = (entry, reference, display) => {
      const { map, shift, exposure, gamma, tone } = display;
      const key = [entry.file, map, shift, exposure, gamma, tone].join();
      let picture = kept.get(key);
      if (!picture) {
        picture = ajar.element("canvas", { width: entry.width, height: entry.height });
        const data = ajar.shadeBlock(entry, reference, 0, 0, entry.width, entry.height, display);
        picture.getContext("2d").putImageData(data, 0, 0);
      }
      kept.delete(key);
      kept.set(key, picture);
      if (kept.size > kKept) kept.delete(kept.keys().next().value);
      return picture;
    };

    return {
      name: "2D canvas",
      clear: () => context.clearRect(0, 0, canvas.width, canvas.height),
      /// Draws columns [left, right) of the canvas.
      draw(entry, reference, view, display, left, right) {
        context.save();
        context.beginPath();
        context.rect(left, 0, right - left, canvas.height);
        context.clip();
        context.imageSmoothingEnabled = view.zoom < 1;
        context.imageSmoothingQuality = "high";
        context.drawImage(shaded(entry, reference, display), view.left, view.top, view.zoom * entry.width, view.zoom * entry.height);
        context.restore();
      },
      finish: () => context.getImageData(0, 0, 1, 1),
    };
  };
}
