// The second tab: metrics, convergence, sweeps, tables, notes.
"use strict";
{
  const section = (title, ...content) => ajar.element("section", {}, ajar.element("h2", {}, title), ...content);
  const scrolled = (table) => ajar.element("div", { class: "scroll" }, table);

  // A column whose cells are all numbers is set to the right: 12, 3.4 ± 0.1 († 1/5), 0.4 (0.97×) (≥ 1/5), 0.46 (0.67 / 0.15), 1.2 [0.9, 1.6] *.
  const isNumber = (text) => /^[\d\s.,eE+−\-±–()[\]/%×*†≥]*(s|ms|dB|GB|MB)?\s*$/.test(text) || /^\s*(nan|inf)?\s*$/i.test(text);

  // Where space is short, what follows a number goes below it: an error, an interval, a remark in brackets.
  const breakable = (text) => text.replace(/ (?![±[(])/g, "\u00a0");

  const makeTable = ({ title, header, rows }) => {
    const numeric = header.map((_, column) => rows.some((row) => row[column].trim()) && rows.every((row) => isNumber(row[column])));
    const side = (column) => (numeric[column] ? "number" : undefined);
    const dense = header.length > 12 ? " dense" : "";
    return section(title, scrolled(ajar.element("table", { class: `data${dense}` },
      ajar.element("thead", {}, ajar.element("tr", {}, ...header.map((text, i) => ajar.element("th", { scope: "col", class: side(i) }, text)))),
      ajar.element("tbody", {}, ...rows.map((row) => ajar.element("tr", {}, ...row.map((text, i) =>
        ajar.element(i === 0 ? "th" : "td", { class: side(i), scope: i === 0 ? "row" : undefined }, numeric[i] ? breakable(text) : text))))))));
  };

  const descriptions = () =>
    ajar.metricNames()
      .map(ajar.describeMetric)
      .filter(({ description }) => description)
      .flatMap(({ name, description, moreIsBetter }) => [
        ajar.element("dt", {}, name),
        ajar.element("dd", {}, `${description} ${moreIsBetter ? "More" : "Less"} is better.`),
      ]);

  /// The sections that the report has content for; those of plots are in the page.
  ajar.makeResults = () => {
    const { tables, notes } = ajar.data;
    // Of several runs, tables and plots say more than the metrics of the pictures that are shown.
    const plots = [...ajar.find("results").children];
    const isStudy = plots.length > 0;
    const sections = [];
    if (notes.length > 0) sections.push(section("Notes", ...notes.map((note) => ajar.element("p", { class: "note" }, note))));
    const metrics = [];
    if (ajar.metricNames().length > 0) {
      const explained = descriptions();
      metrics.push(section(isStudy ? "Metrics of the pictures shown" : "Metrics", scrolled(ajar.makeMetricsTable()), explained.length > 0 ? ajar.element("dl", { class: "explained" }, ...explained) : undefined));
    }
    if (isStudy) sections.push(...tables.map(makeTable));
    else sections.push(...metrics, ...tables.map(makeTable));
    sections.push(...plots);
    if (isStudy) sections.push(...metrics);
    return sections;
  };
}
