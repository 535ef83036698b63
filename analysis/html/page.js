// Draws the charts of the page, each for the setting and the values that the reader picks. All data
// is in the page, packed: a figure of class "chart" has the drawings and rows of every setting.
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

  // ---- data ----

  // The text of an element of class "packed": base64 of what zlib compressed.
  async function unpacked(script) {
    const bytes = Uint8Array.from(atob(script.textContent), (digit) => digit.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).text();
  }

  async function unpackedJson(script) {
    return JSON.parse(await unpacked(script));
  }

  // Rows of a frame as objects.
  function rowsOf(frame, from, to) {
    const columns = frame.columns.map(({name, words, values}) => ({
      name,
      at: words.length ? (row) => words[values[row]] ?? null : (row) => values[row],
    }));
    return Array.from({length: to - from}, (_, row) =>
      Object.fromEntries(columns.map(({name, at}) => [name, at(from + row)])));
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

  // By the rules of csv_text.cpp: no word is a formula to a spreadsheet.
  function csvOf(columns, rows) {
    const field = (value) => {
      const isFormula = typeof value === "string" && /^[=+\-@\t\r]/.test(value) &&
        value !== "-" && Number.isNaN(Number(value));
      const text = value === null ? "" : (isFormula ? "'" : "") + String(value);
      return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    };
    const lines = [columns.map(({title}) => field(title)),
                   ...rows.map((row) => columns.map(({name}) => field(row[name])))];
    return lines.map((line) => line.join(",") + "\n").join("");
  }

  // ---- elements ----

  function element(name, text, attributes = {}) {
    const made = document.createElement(name);
    made.textContent = text;
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  function save(name, type, text) {
    const link = element("a", "", {download: name});
    link.href = URL.createObjectURL(new Blob([text], {type}));
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  const kLongText = 40;  // Characters; a longer cell has several lines.

  function tableOf(columns, rows, caption) {
    const table = document.createElement("table");
    table.append(element("caption", caption));
    const head = table.createTHead().insertRow();
    for (const {title} of columns) head.append(element("th", title, {scope: "col"}));
    const body = table.createTBody();
    for (const row of rows) {
      const line = body.insertRow();
      columns.forEach(({name, format}, place) => {
        const text = shown(row[name], format);
        const kind = text.length > kLongText ? {class: "long"} : {};
        line.append(place === 0 ? element("th", text, {scope: "row"}) : element("td", text, kind));
      });
    }
    return table;
  }

  // ---- the room that a chart has ----

  const kNarrowPx = 700;  // Below, panels stand one below the other and legends above them.
  const kAxisPx = 90;     // Of an axis of y with its title.

  const kGapPx = 35;      // Between panels, with labels of an axis.
  const kLeastPx = 110;   // Of a panel that had more room.

  const kWordsPx = 130;   // Of the labels of an axis of words.

  function narrower(spec, room) {
    const y = spec.encoding?.y;
    const isOfWords = /nominal|ordinal/.test(y?.type);
    if (isOfWords) y.axis = {...y.axis, labelLimit: kWordsPx};
    const left = isOfWords ? kAxisPx / 2 + kWordsPx : kAxisPx;
    if (typeof spec.width === "number") spec.width = Math.min(spec.width, room - left);
    return spec;
  }

  // As many panels side by side as there is room for, narrower if one more fits so.
  function sideBySide(spec, panels, room) {
    const width = panels[0].width ?? 0;
    const least = width > 200 ? width - 40 : Math.min(width, kLeastPx);
    const most = Math.floor((room - kGapPx) / (least + kGapPx));
    spec.columns = Math.max(1, Math.min(spec.columns, most));
    const each = Math.floor((room - kGapPx) / spec.columns) - kGapPx;
    for (const panel of panels)
      if (spec.columns === 1) narrower(panel, room);
      else if (typeof panel.width === "number") panel.width = Math.min(panel.width, each);
    // A heading has no more room than its panel.
    if (spec.facet) spec.facet.header = {labelExpr: "split(datum.label, /: |, | (?== [a-z])/)"};
    return spec;
  }

  // A grid of panels as a list that wraps: a panel is named by its row and its column.
  function wrapped(spec) {
    const {row, column} = spec.facet;
    const names = (part) => (row && column ? [`datum.${row.field}`, `datum.${column.field}`]
                                           : [`datum.${part.field}`]);
    const title = names(row ?? column).join(" + (datum." + (row ?? column).field + " ? ', ' : '') + ");
    const sort = (row?.sort ?? [""]).flatMap((r) => (column?.sort ?? [""]).map((c) =>
      row && column ? (r ? `${r}, ${c}` : c) : r || c));
    return {
      ...spec,
      transform: [...(spec.transform ?? []), {calculate: title, as: "panel"}],
      facet: {field: "panel", title: null, sort},
      columns: 4,
    };
  }

  // The specification with as many panels side by side as there is room for.
  function fitted(given, room) {
    const spec = structuredClone(given);
    if (spec.facet && (spec.facet.row || spec.facet.column)) {
      if (room >= kNarrowPx) return spec;
      return fitted(wrapped(spec), room);
    }
    if (room >= kNarrowPx) return spec;
    if (spec.facet || spec.concat) return sideBySide(spec, spec.concat ?? [spec.spec], room);
    return narrower(spec, room);
  }

  function configFor(room) {
    if (room >= kNarrowPx) return config;
    const legend = {...config.legend, orient: "top", direction: "horizontal",
                    columns: Math.max(1, Math.floor(room / 130))};
    return {...config, legend, title: {...config.title, limit: room - kAxisPx}};
  }

  // ---- figures ----

  // Of scales that name a place in their range for each word, only what the rows have: a legend names
  // nothing that is not there.
  function prune(part, rows) {
    if (part === null || typeof part !== "object") return;
    const {field, scale} = part;
    const isOfWords = typeof scale?.domain?.[0] === "string";
    if (field && isOfWords && scale.domain.length === scale.range?.length) {
      const there = new Set(rows.map((row) => row[field]));
      const kept = scale.domain.map((value) => there.has(value));
      if (kept.some((k) => k)) {
        scale.domain = scale.domain.filter((_, place) => kept[place]);
        scale.range = scale.range.filter((_, place) => kept[place]);
      }
    }
    for (const child of Object.values(part)) prune(child, rows);
  }

  class Figure {
    #figure;
    #pack;
    #picked = {};  // What the reader picked, by column; it outlives a change of the setting.
    #setting = 0;
    #room = 0;

    constructor(figure, pack) {
      this.#figure = figure;
      this.#pack = pack;
      const details = this.#find("details.numbers");
      details.addEventListener("toggle", () => this.#fillTable());
      details.append(element("p", ""));
      const link = element("a", "Save them all as CSV", {href: `#${figure.id}`});
      link.addEventListener("click", (event) => {
        event.preventDefault();
        save(`${figure.id}.csv`, "text/csv", csvOf(this.#columns(), this.#all()));
      });
      details.lastChild.append(link);
    }

    async show(setting) {
      // A chart over all settings is the same in each.
      const isOverAll = this.#pack.settings.length === 1;
      if (isOverAll && this.#room > 0) return;
      this.#setting = isOverAll ? 0 : setting;
      const place = this.#place();
      this.#figure.classList.toggle("without", place === null);
      if (place === null) {
        this.#find("figcaption").textContent = "This setting has no such figures.";
        this.#find(".picks").replaceChildren();
        return;
      }
      this.#find("figcaption").textContent = this.#drawing().caption;
      this.#makePicks();
      await this.draw();
    }

    // Draws again if the room has changed.
    async fit() {
      if (this.#roomNow() !== this.#room) await this.draw();
    }

    async draw() {
      if (this.#place() === null) return;
      this.#room = this.#roomNow();
      const rows = this.#shown();
      const spec = fitted(this.#drawing().spec, this.#room);
      prune(spec, rows);
      try {
        await vegaEmbed(this.#find(".drawing"), {
          $schema: "https://vega.github.io/schema/vega-lite/v6.json",
          ...spec,
          data: {values: rows},
        }, {
          renderer: "svg",
          config: configFor(this.#room),
          actions: {export: {svg: true, png: true}, source: true, compiled: false, editor: true},
          downloadFileName: this.#figure.id,
        });
        this.#figure.dataset.drawn = "true";
      } catch (error) {
        this.#figure.dataset.drawn = "failed";
        console.error(`${this.#figure.id}: ${error.message}`);
      }
      this.#fillTable();
    }

    #find(selector) { return this.#figure.querySelector(selector); }
    #place() { return this.#pack.settings[this.#setting]; }
    #drawing() { return this.#pack.drawings[this.#place().drawing]; }
    #columns() { return this.#pack.frames[this.#place().frame].columns; }
    #roomNow() { return Math.floor(this.#find(".scroll").clientWidth / 20) * 20; }

    #all() {
      const {frame, from, to} = this.#place();
      return rowsOf(this.#pack.frames[frame], from, to);
    }

    #shown() {
      const picks = this.#drawing().picks.map(({column}) => [column, this.#picked[column]]);
      return this.#all().filter((row) => picks.every(([column, value]) => row[column] === value));
    }

    // A control for each column that has several values; those of one value are named.
    #makePicks() {
      const all = this.#all();
      const controls = this.#drawing().picks.map(({column, first}) => {
        const values = [...new Set(all.map((row) => row[column]))];
        if (values.every((value) => typeof value === "number")) values.sort((a, b) => a - b);
        const wanted = [this.#picked[column], first].find((value) => values.includes(value));
        this.#picked[column] = wanted ?? values[0];
        if (values.length === 1 && values[0] === "") return [];
        const {title} = this.#columns().find(({name}) => name === column);
        const label = element("label", `${title} `);
        if (values.length === 1) {
          label.append(element("b", values[0]));
          return [label];
        }
        const select = document.createElement("select");
        for (const value of values) select.append(new Option(value));
        select.selectedIndex = values.indexOf(this.#picked[column]);
        select.addEventListener("change", () => {
          this.#picked[column] = values[select.selectedIndex];
          this.draw();
        });
        label.append(select);
        return [label];
      });
      this.#find(".picks").replaceChildren(...controls.flat());
    }

    // Only while it is open: some have a thousand rows.
    #fillTable() {
      const details = this.#find("details.numbers");
      details.querySelector(".scroll")?.remove();
      if (!details.open) return;
      const scroll = element("div", "", {class: "scroll", tabindex: "0"});
      const caption = this.#find("figcaption").textContent;
      scroll.append(tableOf(this.#columns(), this.#shown(), caption));
      details.append(scroll);
    }
  }

  // Markup that differs between settings.
  class Varying {
    #content;
    #pack;

    constructor(element, pack) {
      this.#content = element.querySelector(".content");
      this.#pack = pack;
    }

    async show(setting) { this.#content.innerHTML = this.#pack.html[this.#pack.settings[setting]]; }
    async fit() {}
  }

  // ---- the page ----

  async function partsOf(selector, Part) {
    const found = [...document.querySelectorAll(selector)];
    return Promise.all(found.map(async (element) =>
      new Part(element, await unpackedJson(element.querySelector("script.packed")))));
  }

  async function showAll(parts, setting) {
    document.body.dataset.setting = setting;
    for (const part of parts) await part.show(setting);
  }

  // The setting with the value that was picked and most of the others' values.
  function nearest(settings, picked, changed) {
    const agreement = (setting) => setting[changed] !== picked[changed] ? -1
      : Object.keys(picked).filter((name) => setting[name] === picked[name]).length;
    const all = settings.map(agreement);
    return all.indexOf(Math.max(...all));
  }

  function prepareSettings(parts) {
    const form = document.getElementById("setting");
    if (!form) return 0;
    const {first, settings} = JSON.parse(form.querySelector("script").textContent);
    const selects = [...form.querySelectorAll("select")];
    form.addEventListener("change", ({target}) => {
      const picked = Object.fromEntries(selects.map((select) => [select.name, select.value]));
      const setting = nearest(settings, picked, target.name);
      for (const select of selects) select.value = settings[setting][select.name];
      showAll(parts, setting);
    });
    return first;
  }

  function prepareDownloads() {
    for (const link of document.querySelectorAll("a.download"))
      link.addEventListener("click", async (event) => {
        event.preventDefault();
        save(link.download, link.dataset.type, await unpacked(link.parentElement
          .querySelector("script.packed")));
      });
  }

  // On paper nothing can be opened: tables are printed, but not the rows behind each chart.
  function preparePrinting() {
    let opened = [];
    window.addEventListener("beforeprint", () => {
      opened = [...document.querySelectorAll("main details:not(.numbers, .drawing *, [open])")];
      for (const details of opened) details.open = true;
    });
    window.addEventListener("afterprint", () => {
      for (const details of opened) details.open = false;
    });
  }

  function prepareResizing(parts) {
    let timer;
    window.addEventListener("resize", () => {
      clearTimeout(timer);
      timer = setTimeout(async () => {
        for (const part of parts) await part.fit();
      }, 200);
    });
  }

  async function start() {
    const begin = performance.now();
    const parts = [...await partsOf("figure.chart", Figure), ...await partsOf(".varies", Varying)];
    const first = prepareSettings(parts);
    prepareDownloads();
    preparePrinting();
    await showAll(parts, first);
    prepareResizing(parts);
    window.lanescope = {drawMs: performance.now() - begin, csvOf};
    performance.mark("lanescope-drawn");
    document.body.dataset.drawn = "true";
  }

  start();
})();
