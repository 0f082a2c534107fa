// The picture: what is drawn where, and moving it with mouse, pen and wheel.
"use strict";
{
  const kLargestZoom = 256;
  const viewer = ajar.find("viewer");
  let picture = ajar.find("picture");
  const overlay = ajar.find("overlay");
  let renderer = null;
  let ratio = 1; // device pixels per CSS pixel

  const imageOf = (key) => ajar.data.images[ajar.state[key]];
  ajar.referenceImage = () => (ajar.data.reference === null ? undefined : ajar.data.images[ajar.data.reference]);

  /// What an error map of the image would be against, if it can be made.
  ajar.referenceFor = (image) => {
    const reference = ajar.referenceImage();
    const sameSize = reference && reference.width === image.width && reference.height === image.height;
    return sameSize && ajar.layerOf(reference, ajar.state.layer) ? reference : undefined;
  };

  const fitZoom = ({ width, height }) => Math.min(picture.width / width, picture.height / height, kLargestZoom);

  /// Where images lie: zoom, and the place of their left upper corner, in device pixels.
  ajar.view = () => {
    const image = imageOf("a");
    const fits = ajar.state.zoom === 0;
    const zoom = fits ? fitZoom(image) : ajar.state.zoom;
    const x = fits ? image.width / 2 : ajar.state.x;
    const y = fits ? image.height / 2 : ajar.state.y;
    // Whole device pixels, so that image pixels of a whole size are sharp.
    return { zoom, ratio, left: Math.round(picture.width / 2 - x * zoom), top: Math.round(picture.height / 2 - y * zoom) };
  };

  /// Image point under a place of the viewer, in CSS pixels from its corner.
  const imagePoint = (place, view = ajar.view()) => ({
    x: (place.x * ratio - view.left) / view.zoom,
    y: (place.y * ratio - view.top) / view.zoom,
  });
  const placeOf = (event) => {
    const box = viewer.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  const keepInside = (value, side) => ajar.clamp(value, 0, side);
  /// Sets the zoom so that the image point under `place` stays there.
  const zoomTo = (zoom, place) => {
    const image = imageOf("a");
    const point = imagePoint(place);
    const next = ajar.clamp(zoom, Math.min(fitZoom(image), 1) / 4, kLargestZoom);
    ajar.set({
      zoom: next,
      x: keepInside(point.x - (place.x * ratio - picture.width / 2) / next, image.width),
      y: keepInside(point.y - (place.y * ratio - picture.height / 2) / next, image.height),
    });
  };
  const middle = () => ({ x: viewer.clientWidth / 2, y: viewer.clientHeight / 2 });

  ajar.fit = () => ajar.set({ zoom: 0 });
  ajar.zoomBy = (factor) => zoomTo(ajar.view().zoom * factor, ajar.cursor ?? middle());
  ajar.zoomToPixels = () => zoomTo(ratio, ajar.cursor ?? middle());

  // ------------------------------------------------------------------ drawing

  const problem = (image) => {
    const { layer, map } = ajar.state;
    if (!ajar.layerOf(image, layer)) return `“${image.name}” has no layer “${layer || "picture"}”.`;
    if (map !== "colour" && !ajar.referenceFor(image)) return `The reference differs from “${image.name}” in size or layers.`;
    return ajar.pixels.failure(image, layer) ?? (map !== "colour" && ajar.pixels.failure(ajar.referenceImage(), layer));
  };

  /// Draws the image into columns [left, right) if it is there, else asks for it. Returns whether it was drawn.
  const drawImage = (image, view, left, right) => {
    const { layer, map } = ajar.state;
    if (problem(image)) return false;
    const needed = [image, ...(map === "colour" ? [] : [ajar.referenceImage()])];
    const entries = needed.map((one) => ajar.pixels.get(one, layer));
    if (entries.every(Boolean)) {
      renderer.draw(entries[0], entries[1], view, ajar.state, left, right);
      return true;
    }
    Promise.all(needed.map((one) => ajar.pixels.request(one, layer))).then(ajar.redraw);
    return false;
  };

  const drawNow = () => {
    if (!renderer || ajar.state.tab !== "images") return;
    const { mode, split } = ajar.state;
    const view = ajar.view();
    const middleColumn = mode === "split" ? Math.round(split * picture.width) : picture.width;
    const sides = [{ image: imageOf("a"), left: 0, right: middleColumn }];
    if (mode === "split") sides.push({ image: imageOf("b"), left: middleColumn, right: picture.width });
    renderer.clear();
    for (const side of sides) side.drawn = drawImage(side.image, view, side.left, side.right);
    ajar.drawOverlay(overlay, view, sides);
    const message = ajar.find("message");
    const problems = [...new Set(sides.map((side) => problem(side.image)).filter(Boolean))];
    message.hidden = problems.length === 0;
    message.textContent = problems.join(" ");
    viewer.dataset.drawn = sides.every((side) => side.drawn) ? sides.map((side) => side.image.index).join() : "";
  };
  /// Draws soon; drawNow at once, for measuring.
  ajar.redraw = ajar.perFrame(drawNow);
  ajar.drawNow = drawNow;

  const showLabels = () => {
    const { mode, split } = ajar.state;
    const isSplit = mode === "split";
    for (const key of ["a", "b"]) {
      const label = ajar.find(`label-${key}`);
      const image = imageOf(key);
      label.hidden = key === "b" && !isSplit;
      const isReference = image.index === ajar.data.reference;
      label.replaceChildren(
        ...(isSplit ? [ajar.element("b", {}, key.toUpperCase()), " "] : []),
        image.name,
        ...(isReference ? [ajar.element("span", { class: "tag" }, "reference")] : []),
      );
    }
    const divider = ajar.find("divider");
    divider.hidden = !isSplit;
    divider.style.left = `${100 * split}%`;
    divider.setAttribute("aria-valuenow", Math.round(100 * split));
  };

  // ------------------------------------------------------------------ size

  const resize = () => {
    ratio = window.devicePixelRatio || 1;
    for (const canvas of [picture, overlay]) {
      canvas.width = Math.max(1, Math.round(viewer.clientWidth * ratio));
      canvas.height = Math.max(1, Math.round(viewer.clientHeight * ratio));
    }
    // At once: a canvas is empty after a change of its size.
    drawNow();
  };

  // ------------------------------------------------------------------ mouse and pen

  const onWheel = (event) => {
    event.preventDefault();
    // Lines and pages, as some browsers count, in pixels.
    const pixels = event.deltaY * [1, 32, 400][event.deltaMode];
    zoomTo(ajar.view().zoom * 2 ** ajar.clamp(-pixels / 240, -1, 1), placeOf(event));
  };

  /// Follows the pointer until it is released: `move(place, start place)`.
  const follow = (event, target, move) => {
    const start = placeOf(event);
    target.setPointerCapture(event.pointerId);
    const onMove = (moved) => move(placeOf(moved), start);
    const onEnd = () => {
      target.removeEventListener("pointermove", onMove);
      target.removeEventListener("pointerup", onEnd);
      target.removeEventListener("pointercancel", onEnd);
      viewer.classList.remove("dragging");
    };
    target.addEventListener("pointermove", onMove);
    target.addEventListener("pointerup", onEnd);
    target.addEventListener("pointercancel", onEnd);
    viewer.classList.add("dragging");
  };

  const startDrag = (event) => {
    if (event.button > 1 || event.target === ajar.find("divider") || event.target.closest(".legend, .divider")) return;
    event.preventDefault();
    viewer.focus({ preventScroll: true });
    const moveInset = event.button === 0 && ajar.grabInset(imagePoint(placeOf(event)), ajar.view());
    if (moveInset) {
      follow(event, viewer, (place) => moveInset(imagePoint(place)));
      return;
    }
    const image = imageOf("a");
    const view = ajar.view();
    const centre = { x: (picture.width / 2 - view.left) / view.zoom, y: (picture.height / 2 - view.top) / view.zoom };
    follow(event, viewer, (place, start) =>
      ajar.set({
        zoom: view.zoom,
        x: keepInside(centre.x - ((place.x - start.x) * ratio) / view.zoom, image.width),
        y: keepInside(centre.y - ((place.y - start.y) * ratio) / view.zoom, image.height),
      }),
    );
  };

  const setCursor = (place) => {
    ajar.cursor = place;
    ajar.cursorPixel = undefined;
    if (place) {
      const { x, y } = imagePoint(place);
      ajar.cursorPixel = { x: Math.floor(x), y: Math.floor(y) };
      viewer.classList.toggle("over-inset", ajar.insetAt({ x, y }, ajar.view()) !== undefined);
    }
    ajar.showValues();
  };

  const prepareDivider = () => {
    const divider = ajar.find("divider");
    const moveTo = (share) => ajar.set({ split: ajar.clamp(share, 0, 1) });
    divider.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      divider.focus();
      follow(event, divider, (place) => moveTo(place.x / viewer.clientWidth));
    });
    divider.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      moveTo(ajar.state.split + step);
    });
  };

  ajar.startViewer = () => {
    const largestSide = Math.max(...ajar.data.images.flatMap(({ width, height }) => [width, height]));
    const wanted = new URLSearchParams(location.search).get("renderer");
    if (wanted !== "canvas") {
      try {
        renderer = ajar.makeWebGlRenderer(picture, largestSide, wanted === "webgl");
      } catch (error) {
        console.warn(`WebGL cannot be used: ${error.message}`);
      }
    }
    if (!renderer) {
      // A canvas that has been asked for WebGL gives nothing else.
      const fresh = picture.cloneNode();
      picture.replaceWith(fresh);
      picture = fresh;
      renderer = ajar.makeCanvasRenderer(picture);
    }
    ajar.renderer = renderer;
    new ResizeObserver(resize).observe(viewer);
    viewer.addEventListener("wheel", onWheel, { passive: false });
    viewer.addEventListener("pointerdown", startDrag);
    viewer.addEventListener("pointermove", (event) => setCursor(placeOf(event)));
    viewer.addEventListener("pointerleave", () => setCursor(undefined));
    viewer.addEventListener("dblclick", (event) => {
      if (!event.target.closest(".legend, .divider")) ajar.fit();
    });
    prepareDivider();
    ajar.onChange(() => {
      showLabels();
      ajar.showLegend();
      ajar.redraw();
      setCursor(ajar.cursor);
    });
    showLabels();
    ajar.showLegend();
    resize();
  };
}
