// The list of images at the left.
"use strict";
{
  const list = ajar.find("list");
  let rows = [];

  const makeRow = (image) => {
    const picture = ajar.element("img", { src: `data/${image.thumbnail}`, alt: "", loading: "lazy" });
    const number = image.index < 9 ? ajar.element("kbd", {}, String(image.index + 1)) : undefined;
    const isReference = image.index === ajar.data.reference;
    const metric = ajar.element("span", { class: "row-metric" });
    const row = ajar.element("div", { class: "row" },
      ajar.element("button", { class: "row-show", onclick: () => ajar.set({ a: image.index }) },
        picture,
        ajar.element("span", { class: "row-text" },
          ajar.element("span", { class: "row-name", title: image.name }, image.name),
          isReference ? ajar.element("span", { class: "tag" }, "reference") : metric),
        number),
      ajar.element("button", {
        class: "row-b",
        title: `Show ${image.name} on the right of the split view`,
        "aria-label": `${image.name} on the right`,
        onclick: () => ajar.set({ b: image.index, mode: "split" }),
      }, "B"),
    );
    return { row, metric };
  };

  const showMetric = (name) => {
    ajar.data.images.forEach((image, i) => {
      const value = image.metrics[name];
      rows[i].metric.replaceChildren(value === undefined ? "" : ajar.format(ajar.number(value), 3));
    });
  };

  const update = () => {
    const { a, b, mode } = ajar.state;
    rows.forEach(({ row }, i) => {
      row.classList.toggle("is-a", i === a);
      row.classList.toggle("is-b", mode === "split" && i === b);
      row.firstChild.setAttribute("aria-current", i === a ? "true" : "false");
    });
  };

  ajar.startList = () => {
    rows = ajar.data.images.map(makeRow);
    const names = ajar.metricNames();
    const choice = ajar.element("select", { "aria-label": "Metric in the list", onchange: (event) => showMetric(event.target.value) },
      ...names.map((name) => ajar.element("option", {}, name)));
    list.replaceChildren(
      ajar.element("div", { class: "side-head" }, ajar.element("h2", {}, `${rows.length} image${rows.length === 1 ? "" : "s"}`), names.length > 0 ? choice : undefined),
      ajar.element("div", { class: "rows" }, ...rows.map(({ row }) => row)),
    );
    if (names.length > 0) showMetric(names[0]);
    ajar.onChange((changed) => {
      update();
      if (changed.has("a")) rows[ajar.state.a].row.scrollIntoView({ block: "nearest" });
    });
    update();
  };
}
