// All metrics of all images, sortable.
"use strict";
{
  const describe = (name) => ajar.data.metrics.find((metric) => metric.name === name) ?? { name, description: "", moreIsBetter: false };

  /// In the report's order, then those it does not describe.
  ajar.metricNames = () => {
    const used = new Set(ajar.data.images.flatMap((image) => Object.keys(image.metrics)));
    const known = ajar.data.metrics.map(({ name }) => name).filter((name) => used.has(name));
    return [...known, ...[...used].filter((name) => !known.includes(name)).sort()];
  };

  const valueOf = (image, name) => (image.metrics[name] === undefined ? undefined : ajar.number(image.metrics[name]));

  /// The best value of the images other than the reference, or undefined if there is no contest.
  const best = (name) => {
    const values = ajar.data.images
      .filter(({ index }) => index !== ajar.data.reference)
      .map((image) => valueOf(image, name))
      .filter((value) => value !== undefined && !Number.isNaN(value));
    if (values.length < 2) return undefined;
    return describe(name).moreIsBetter ? Math.max(...values) : Math.min(...values);
  };

  const compare = (a, b, ascending) => {
    const missing = (value) => value === undefined || Number.isNaN(value);
    if (missing(a) || missing(b)) return missing(a) - missing(b);
    if (a === b) return 0;
    return (a < b ? -1 : 1) * (ascending ? 1 : -1);
  };

  let sorted = { name: null, ascending: true };

  const sortedImages = () => {
    const { name, ascending } = sorted;
    if (name === null) return ajar.data.images;
    return [...ajar.data.images].sort((a, b) => compare(valueOf(a, name), valueOf(b, name), ascending));
  };

  const headerCell = (name, redraw) => {
    const { description, moreIsBetter } = describe(name);
    const isSorted = sorted.name === name;
    const sort = () => {
      // The first click puts the best on top.
      sorted = { name, ascending: isSorted ? !sorted.ascending : !moreIsBetter };
      redraw(name);
    };
    return ajar.element("th", { scope: "col", class: "number", "aria-sort": isSorted ? (sorted.ascending ? "ascending" : "descending") : "none" },
      ajar.element("button", { onclick: sort, "data-metric": name, title: `${description}${description ? " — " : ""}${moreIsBetter ? "more" : "less"} is better. Sort.` },
        name, ajar.element("span", { class: "arrow", "aria-hidden": "true" }, isSorted ? (sorted.ascending ? "▲" : "▼") : "")));
  };

  const cell = (image, name) => {
    const value = valueOf(image, name);
    if (value === undefined) return ajar.element("td", { class: "number" }, "–");
    const isBest = image.index !== ajar.data.reference && value === best(name);
    return ajar.element("td", { class: isBest ? "number best" : "number" },
      ...(isBest ? [ajar.element("span", { class: "tag" }, "best")] : []), ajar.format(value));
  };

  const nameCell = (image) =>
    ajar.element("th", { scope: "row" },
      ajar.element("button", { class: "link", onclick: () => ajar.set({ tab: "images", a: image.index }) }, image.name),
      ...(image.index === ajar.data.reference ? [ajar.element("span", { class: "tag" }, "reference")] : []));

  /// A table that redraws itself when sorted.
  ajar.makeMetricsTable = () => {
    const table = ajar.element("table", { class: "data", id: "metrics" });
    const redraw = (focused) => {
      const names = ajar.metricNames();
      table.replaceChildren(
        ajar.element("thead", {}, ajar.element("tr", {}, ajar.element("th", { scope: "col" }, "Image"), ...names.map((name) => headerCell(name, redraw)))),
        ajar.element("tbody", {}, ...sortedImages().map((image) => ajar.element("tr", {}, nameCell(image), ...names.map((name) => cell(image, name))))),
      );
      [...table.querySelectorAll("th button")].find((button) => button.dataset.metric === focused)?.focus();
    };
    redraw();
    return table;
  };
  ajar.describeMetric = describe;
}
