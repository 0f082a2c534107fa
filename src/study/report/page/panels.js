// The panels at the right: values under the cursor in all images, and what is known of the image.
"use strict";
{
  const css = (rgb) => `rgb(${rgb.map((x) => Math.round(255 * x)).join(" ")})`;
  let rows = [];

  const makeRows = () => {
    rows = ajar.data.images.map((image) => {
      const swatch = ajar.element("span", { class: "swatch" });
      const value = ajar.element("span", { class: "value" });
      const row = ajar.element("div", { class: "value-row" }, swatch,
        ajar.element("span", { class: "value-name", title: image.name }, image.name), value);
      return { row, swatch, value };
    });
    ajar.find("values").replaceChildren(...rows.map(({ row }) => row));
  };

  const textOf = (entry, reference, index) => {
    if (ajar.state.map !== "colour") return ajar.format(ajar.errorAt(entry, reference, index, ajar.state.map));
    const value = ajar.valueAt(entry, index);
    return (entry.channels === 1 ? value.slice(0, 1) : value).map((x) => ajar.format(x, 4)).join("  ");
  };

  const showRow = ({ swatch, value }, image, pixel) => {
    const { layer, map } = ajar.state;
    const entry = ajar.pixels.has(image, layer) ? ajar.pixels.get(image, layer) : undefined;
    const referenceImage = map === "colour" ? undefined : ajar.referenceFor(image);
    const reference = referenceImage && ajar.pixels.has(referenceImage, layer) ? ajar.pixels.get(referenceImage, layer) : undefined;
    const inside = pixel && pixel.x >= 0 && pixel.y >= 0 && pixel.x < image.width && pixel.y < image.height;
    if (!entry || !inside || (map !== "colour" && !reference)) {
      value.textContent = entry || !pixel ? "–" : ajar.layerOf(image, layer) ? "…" : "no layer";
      swatch.style.background = "none";
      return;
    }
    const index = pixel.y * image.width + pixel.x;
    value.textContent = textOf(entry, reference, index);
    swatch.style.background = css(ajar.shade(entry, reference, index, ajar.state));
  };

  /// Shows the values under the cursor (ajar.cursorPixel) of all images that are loaded.
  ajar.showValues = ajar.perFrame(() => {
    const pixel = ajar.cursorPixel;
    ajar.find("position").textContent = pixel ? `${pixel.x}, ${pixel.y}` : "";
    ajar.data.images.forEach((image, i) => {
      showRow(rows[i], image, pixel);
      rows[i].row.classList.toggle("current", i === ajar.state.a);
    });
  });

  const showMetadata = () => {
    const image = ajar.data.images[ajar.state.a];
    const facts = [["Name", image.name], ["Size", `${image.width} × ${image.height}`]];
    for (const name of ajar.metricNames()) {
      if (image.metrics[name] !== undefined) facts.push([name, ajar.format(ajar.number(image.metrics[name]))]);
    }
    facts.push(...image.metadata);
    ajar.find("metadata").replaceChildren(
      ajar.element("dl", {}, ...facts.flatMap(([key, value]) => [ajar.element("dt", {}, key), ajar.element("dd", {}, value)])),
    );
  };

  ajar.startPanels = () => {
    makeRows();
    showMetadata();
    ajar.showValues();
    const main = ajar.find("images");
    const togglePanels = () => main.classList.toggle("bare", !ajar.state.panels);
    togglePanels();
    ajar.onChange((changed) => {
      if (changed.has("a")) showMetadata();
      if (changed.has("panels")) togglePanels();
    });
  };
}
