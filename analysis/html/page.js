// Draws the charts of the page and, when they are opened, the tables of their numbers. All data is
// in the page: each figure of class "chart" has a JSON element with its Vega-Lite specification and
// its rows by columns.
"use strict";
(() => {
  // Text, axes and rules take the colour of the page's text, so that light, dark and print need no
  // second drawing.
  const ink = "currentColor";
  const grid = "rgba(128, 128, 128, 0.25)";
  const config = {
    background: "transparent",
    font: "system-ui, 'Liberation Sans', sans-serif",
    title: {color: ink, anchor: "start", fontSize: 13},
    axis: {
      labelColor: ink, titleColor: ink, domainColor: ink, tickColor: ink, gridColor: grid,
      labelFontSize: 11, titleFontSize: 11, titleFontWeight: "normal",
    },
    legend: {
      labelColor: ink, titleColor: ink, symbolBaseFillColor: ink, symbolBaseStrokeColor: ink,
      labelFontSize: 11, titleFontSize: 11, labelLimit: 260, symbolStrokeWidth: 2,
    },
    header: {labelColor: ink, titleColor: ink, labelFontSize: 12, labelFontWeight: "bold"},
    text: {color: ink},
    view: {stroke: grid},
    range: {symbol: ["circle", "triangle-up", "square", "diamond"]},
  };

  // Columns as {name, title, format, at(row)}.
  function readColumns(data) {
    return data.columns.map(({name, title, format, words, values}) => ({
      name, title, format,
      at: words.length ? (row) => words[values[row]] ?? null : (row) => values[row],
    }));
  }

  function readRows(data) {
    const columns = readColumns(data);
    return Array.from({length: data.rows}, (_, row) =>
      Object.fromEntries(columns.map((column) => [column.name, column.at(row)])));
  }

  // A value as a table shows it, by a format: a sign or not, decimals, and whether it is a
  // percentage (".1%", "+.1f").
  function shown(value, format) {
    if (value === null) return "–";
    const [, sign, decimals, kind] = /^(\+?)\.(\d)([%f])$/.exec(format) ?? [];
    if (kind === undefined || typeof value !== "number") return String(value);
    const digits = (kind === "%" ? 100 * value : value).toFixed(Number(decimals));
    return (sign && value > 0 ? "+" : "") + digits + (kind === "%" ? "%" : "");
  }

  function element(name, text, attributes = {}) {
    const made = document.createElement(name);
    made.textContent = text;
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  function tableOf(data, caption) {
    const columns = readColumns(data);
    const table = document.createElement("table");
    table.append(element("caption", caption));
    const head = table.createTHead().insertRow();
    for (const {title} of columns) head.append(element("th", title, {scope: "col"}));
    const body = table.createTBody();
    for (let row = 0; row < data.rows; ++row) {
      const line = body.insertRow();
      columns.forEach((column, place) => {
        const text = shown(column.at(row), column.format);
        line.append(place === 0 ? element("th", text, {scope: "row"}) : element("td", text));
      });
    }
    return table;
  }

  // Fills the table of a figure when it is opened: some have ten thousand rows.
  function prepareTable(figure, data) {
    const details = figure.querySelector("details.numbers");
    details.addEventListener("toggle", () => {
      if (details.querySelector("table")) return;
      const scroll = element("div", "", {class: "scroll", tabindex: "0"});
      scroll.append(tableOf(data, figure.querySelector("figcaption").textContent));
      details.append(scroll);
    });
  }

  async function draw(figure, {spec, data}) {
    const whole = {
      $schema: "https://vega.github.io/schema/vega-lite/v6.json",
      ...spec,
      data: {values: readRows(data)},
    };
    await vegaEmbed(figure.querySelector(".drawing"), whole, {
      renderer: "svg",
      config,
      actions: {export: {svg: true, png: true}, source: true, compiled: false, editor: true},
      downloadFileName: figure.id,
    });
    figure.dataset.drawn = "true";
  }

  async function drawAll() {
    const start = performance.now();
    for (const figure of document.querySelectorAll("figure.chart")) {
      const content = JSON.parse(figure.querySelector("script").textContent);
      prepareTable(figure, content.data);
      try {
        await draw(figure, content);
      } catch (error) {
        figure.dataset.drawn = "failed";
        console.error(`${figure.id}: ${error.message}`);
      }
    }
    window.lanescope = {drawMs: performance.now() - start};
    performance.mark("lanescope-drawn");
    document.body.dataset.drawn = "true";
  }

  drawAll();
})();
