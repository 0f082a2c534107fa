// Insets: the same small square of all images side by side, under the picture. Frames in the picture move them.
"use strict";
{
  ajar.kMaxInsets = 3;
  const kSmallest = 8; // image pixels
  const kGrab = 9; // CSS pixels around the corner that resizes
  const strip = ajar.find("insets");

  const imageA = () => ajar.data.images[ajar.state.a];
  const sizeLimits = ({ width, height }) => Math.min(width, height);

  /// Index of the topmost inset whose frame holds the image point.
  ajar.insetAt = (point, view) => {
    const slack = (kGrab * view.ratio) / view.zoom;
    const { insets } = ajar.state;
    for (let i = insets.length - 1; i >= 0; --i) {
      const { x, y, size } = insets[i];
      const inside = (value, low) => value >= low - slack / 2 && value <= low + size + slack / 2;
      if (inside(point.x, x) && inside(point.y, y)) return i;
    }
    return undefined;
  };

  const replace = (index, inset) => ajar.set({ insets: ajar.state.insets.map((old, i) => (i === index ? inset : old)) });

  const placed = ({ x, y, size }) => {
    const { width, height } = imageA();
    const side = ajar.clamp(Math.round(size), Math.min(kSmallest, sizeLimits(imageA())), sizeLimits(imageA()));
    return {
      x: ajar.clamp(Math.round(x), 0, width - side),
      y: ajar.clamp(Math.round(y), 0, height - side),
      size: side,
    };
  };

  /// If the image point is on an inset: the function that moves (or, from its corner, resizes) it to a point.
  ajar.grabInset = (point, view) => {
    const index = ajar.insetAt(point, view);
    if (index === undefined) return undefined;
    const { x, y, size } = ajar.state.insets[index];
    const slack = (kGrab * view.ratio) / view.zoom;
    if (Math.abs(point.x - x - size) < slack && Math.abs(point.y - y - size) < slack) {
      return (to) => {
        const room = Math.min(imageA().width - x, imageA().height - y);
        replace(index, placed({ x, y, size: Math.min(Math.max(to.x - x, to.y - y), room) }));
      };
    }
    return (to) => replace(index, placed({ x: x + to.x - point.x, y: y + to.y - point.y, size }));
  };

  /// Adds one where the reader looks.
  ajar.addInset = () => {
    const { insets } = ajar.state;
    if (insets.length >= ajar.kMaxInsets) return;
    const { width, height } = imageA();
    const view = ajar.view();
    const canvas = ajar.find("overlay");
    const centre = {
      x: ajar.clamp((canvas.width / 2 - view.left) / view.zoom, 0, width),
      y: ajar.clamp((canvas.height / 2 - view.top) / view.zoom, 0, height),
    };
    const seen = Math.min(sizeLimits(imageA()), canvas.height / view.zoom);
    const size = Math.max(seen / 6, kSmallest);
    const shift = (insets.length - 1) * 1.5 * size;
    ajar.set({ insets: [...insets, placed({ x: centre.x - size / 2 + shift, y: centre.y - size / 2, size })] });
  };

  ajar.toggleInsets = () => {
    if (ajar.state.insets.length > 0) {
      ajar.set({ insets: [] });
      return;
    }
    ajar.addInset();
    ajar.addInset();
  };

  // ------------------------------------------------------------------ the strip

  const relativeError = (entry, reference, { x, y, size }) => {
    let sum = 0;
    for (let row = y; row < y + size; ++row) {
      for (let column = x; column < x + size; ++column) {
        sum += ajar.errorAt(entry, reference, row * entry.width + column, "relative");
      }
    }
    return sum / (size * size);
  };

  const inside = ({ x, y, size }, image) => x + size <= image.width && y + size <= image.height;

  const drawCrop = (canvas, caption, image, inset) => {
    const { layer, map } = ajar.state;
    const referenceImage = ajar.referenceFor(image);
    const entry = ajar.pixels.get(image, layer);
    const reference = referenceImage && ajar.pixels.get(referenceImage, layer);
    if (!inside(inset, image) || !ajar.layerOf(image, layer) || (map !== "colour" && !referenceImage)) {
      caption.textContent = "not there";
      canvas.width = canvas.height = 1;
      return;
    }
    if (!entry || (map !== "colour" && !reference)) {
      caption.textContent = ajar.pixels.failure(image, layer) ? "missing" : "loading …";
      return;
    }
    canvas.width = canvas.height = inset.size;
    const { x, y, size } = inset;
    canvas.getContext("2d").putImageData(ajar.shadeBlock(entry, reference, x, y, size, size, ajar.state), 0, 0);
    if (image.index === ajar.data.reference) caption.textContent = "reference";
    else caption.textContent = reference ? `relMSE ${ajar.format(relativeError(entry, reference, inset), 3)}` : "";
  };

  let cells = []; // [inset][image] → {canvas, caption}

  const makeCell = (image, index) => {
    const canvas = ajar.element("canvas", { width: 1, height: 1 });
    const caption = ajar.element("span", { class: "inset-caption" });
    const node = ajar.element("button", {
      class: "inset",
      style: `--frame:${ajar.palette[index]}`,
      title: `Show ${image.name}`,
      onclick: () => ajar.set({ a: image.index }),
    }, canvas, caption);
    return { canvas, caption, node };
  };

  // The reference leads: the eye compares with the first.
  const ordered = () => {
    const { images, reference } = ajar.data;
    return reference === null ? images : [images[reference], ...images.filter(({ index }) => index !== reference)];
  };

  const build = () => {
    cells = ajar.state.insets.map((_, i) => ajar.data.images.map((image) => makeCell(image, i)));
    const columns = ordered().map((image) =>
      ajar.element("figure", { class: "inset-column", "data-image": image.index },
        ajar.element("figcaption", { title: image.name }, image.name),
        ...cells.map((row) => row[image.index].node)),
    );
    strip.replaceChildren(
      ajar.element("div", { class: "inset-tools" },
        ajar.element("button", { onclick: ajar.addInset, disabled: ajar.state.insets.length >= ajar.kMaxInsets, title: "One more inset" }, "+"),
        ajar.element("button", { onclick: () => ajar.set({ insets: ajar.state.insets.slice(0, -1) }), title: "One inset less" }, "−"),
      ),
      ...columns,
    );
  };

  const drawNow = () => {
    const { insets, a, layer } = ajar.state;
    const wasHidden = strip.hidden;
    strip.hidden = insets.length === 0;
    if (strip.hidden) {
      cells = [];
      return;
    }
    if (cells.length !== insets.length || wasHidden) build();
    insets.forEach((inset, i) => cells[i].forEach(({ canvas, caption }, j) => drawCrop(canvas, caption, ajar.data.images[j], inset)));
    for (const column of strip.querySelectorAll(".inset-column")) {
      column.classList.toggle("current", Number(column.dataset.image) === a);
    }
    const missing = ajar.data.images.filter((image) => ajar.layerOf(image, layer) && !ajar.pixels.has(image, layer) && !ajar.pixels.failure(image, layer));
    // One after the other; each draws the strip again. More than fit into memory would chase each other for ever.
    if (missing.length > 0 && ajar.pixels.hasRoom(missing[0])) ajar.pixels.request(missing[0], layer).then(draw);
  };
  const draw = ajar.perFrame(drawNow);

  ajar.startInsets = () => {
    const kinds = ["insets", "a", "layer", "map", "shift", "exposure", "gamma", "tone"];
    ajar.onChange((changed) => {
      if (kinds.some((kind) => changed.has(kind))) draw();
    });
    draw();
  };
}
