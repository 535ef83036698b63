// SPDX-License-Identifier: MIT
// node check.mjs PAGE [--pictures DIR]
//
// Opens a page of `lanescope report` in a headless Chromium, light and dark, narrow and wide, and
// checks that it begins with the answer, draws every chart and fills every table in letters that can
// be read, without an error and without a request to anywhere, and that it prints its tables. Says
// how long drawing took. With --pictures, writes PNG files and a PDF of the page.
import {writeFileSync} from "node:fs";
import {resolve} from "node:path";
import {parseArgs} from "node:util";
import {pathToFileURL} from "node:url";

import {Browser} from "./browser.mjs";

const {positionals, values: options} = parseArgs({
  allowPositionals: true,
  options: {pictures: {type: "string"}, chromium: {type: "string", default: "chromium"}},
});
const [path] = positionals;
const failures = [];

function expect(holds, complaint) {
  if (!holds) failures.push(complaint);
}

// Runs within the page: what there is to be seen of it.
async function survey() {
  const unpackedText = async (script) => {
    const bytes = Uint8Array.from(atob(script.textContent), (digit) => digit.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).text();
  };
  // What is neither a form of the values that were picked nor of the setting is not shown.
  const shownRows = (pack, figure) => {
    const setting = Number(document.body.dataset.setting);
    const {drawing, frame, from, to} = pack.settings[pack.settings.length > 1 ? setting : 0];
    const picked = [...figure.querySelectorAll(".picks label")].map((label) =>
      label.querySelector("select")?.value ?? label.querySelector("b").textContent);
    const columns = pack.drawings[drawing].picks
      .map(({column}) => pack.frames[frame].columns.find(({name}) => name === column))
      .map(({words, values}) => (row) => String(words.length ? words[values[row]] : values[row]))
      .filter((at) => at(from) !== "");
    let count = 0;
    for (let row = from; row < to; ++row)
      count += columns.every((at, place) => at(row) === picked[place]);
    return count;
  };
  const charts = [];
  for (const figure of document.querySelectorAll("figure.chart:not(.without)")) {
    const svg = figure.querySelector(".drawing svg");
    const details = figure.querySelector("details.numbers");
    details.open = true;
    details.dispatchEvent(new Event("toggle"));
    const text = svg?.querySelector(".role-axis-label text");
    const pack = JSON.parse(await unpackedText(figure.querySelector("script.packed")));
    charts.push({
      id: figure.id,
      drawn: figure.dataset.drawn,
      marks: svg?.querySelectorAll(".role-mark path, .role-mark line, .role-mark text").length ?? 0,
      described: figure.querySelector(".drawing [role='graphics-document']")
        ?.getAttribute("aria-label")?.length > 10,
      width: svg?.getBoundingClientRect().width ?? 0,
      height: svg?.getBoundingClientRect().height ?? 0,
      // Letters on the screen over letters as they were drawn.
      scale: svg ? svg.getBoundingClientRect().width / svg.viewBox.baseVal.width : 0,
      ink: text ? getComputedStyle(text).fill : "",
      labelledSelects: [...figure.querySelectorAll("select")].every((s) => s.closest("label")),
      legend: [...(svg?.querySelectorAll(".role-legend-label text") ?? [])]
        .map((label) => label.textContent),
      rows: shownRows(pack, figure),
      tableRows: details.querySelectorAll("tbody tr").length,
      caption: details.querySelector("caption")?.textContent ?? "",
      columnHeadings: details.querySelectorAll("thead th[scope=col]").length,
    });
    details.open = false;
  }
  const downloads = [];
  for (const link of document.querySelectorAll("a.download"))
    downloads.push({
      file: link.download,
      text: (await unpackedText(link.parentElement.querySelector("script.packed"))).slice(0, 100),
    });
  const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
  return {
    charts,
    downloads,
    sections: [...document.querySelectorAll("main h2")].map((heading) => heading.id),
    answer: document.querySelector("#answer").parentElement.querySelector("td")?.textContent,
    drawMs: window.lanescope?.drawMs,
    csv: window.lanescope?.csvOf([{title: "=a", name: "a"}],
                                 [{a: "=1+1"}, {a: "@x"}, {a: "-3"}, {a: -2}, {a: "-"}, {a: null},
                                  {a: 'b,"c'}]),
    marked: performance.getEntriesByName("lanescope-drawn").length,
    headings: [...document.querySelectorAll("h1,h2,h3,h4")].map((h) => Number(h.tagName[1])),
    repeatedIds: ids.filter((id, place) => ids.indexOf(id) !== place),
    brokenLinks: [...document.querySelectorAll("a[href^='#']")]
      .map((a) => a.getAttribute("href").slice(1))
      .filter((id) => id && !document.getElementById(id)),
    lang: document.documentElement.lang,
    imagesWithoutWords: [...document.images].filter((i) => !i.alt || !i.naturalWidth).length,
    tablesWithoutCaption: [...document.querySelectorAll("table")].filter((t) => !t.caption).length,
    ink: getComputedStyle(document.body).color,
    paper: getComputedStyle(document.body).backgroundColor,
    overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  };
}

// Runs within the page: picks something else beside each chart, or another setting, and waits for
// what it draws; the ids of charts that stay as they were.
async function pick(selector) {
  // Charts over all settings stay as they are when another setting is picked.
  const figures = selector.startsWith("#setting") ? "figure.chart:not(.without, [id^=over-])"
                                                  : "figure.chart:has(select)";
  const drawings = () => [...document.querySelectorAll(figures)]
    .map((figure) => ({id: figure.id, svg: figure.querySelector("svg").outerHTML}));
  const before = drawings();
  for (const select of document.querySelectorAll(selector)) {
    select.selectedIndex = (select.selectedIndex + 1) % select.options.length;
    select.dispatchEvent(new Event("change", {bubbles: true}));
  }
  const same = () => drawings().filter(({id, svg}) =>
    svg === before.find((other) => other.id === id)?.svg);
  for (let waited = 0; same().length > 0 && waited < 10000; waited += 100)
    await new Promise((wake) => setTimeout(wake, 100));
  return same().map(({id}) => id);
}

// Runs within the page: which details are open while it is printed, by their summaries.
function watchPrinting() {
  window.addEventListener("beforeprint", () => {
    const details = [...document.querySelectorAll("details:not(.drawing *)")];
    window.openOnPaper = details.map((d) => [d.querySelector("summary").textContent, d.open]);
  });
}

function checkSurvey(seen, scheme) {
  const about = (text) => `${scheme}: ${text}`;
  expect(seen.charts.length > 0, about("has no charts"));
  expect(seen.sections[0] === "answer" && /\d/.test(seen.answer),
         about(`begins with ${seen.sections[0]}, which says ${seen.answer}`));
  expect(seen.sections.slice(-2).join() === "runs,downloads", about("does not end with the runs"));
  expect(seen.downloads.some(({text}) => text.includes('"lanescope-report"')),
         about("has no report to save"));
  expect(seen.downloads.filter(({file}) => file.endsWith(".csv"))
    .every(({text}) => text.split(",").length > 3), about("has no CSV to save"));
  expect(seen.csv === "'=a\n'=1+1\n'@x\n-3\n-2\n-\n\n\"b,\"\"c\"\n",
         about(`saves what is no CSV of the program: ${seen.csv}`));
  expect(seen.drawMs > 0 && seen.marked === 1, about("does not say how long drawing took"));
  expect(seen.lang === "en", about("has no language"));
  expect(seen.repeatedIds.length === 0, about(`has ids twice: ${seen.repeatedIds}`));
  expect(seen.brokenLinks.length === 0, about(`has links to nowhere: ${seen.brokenLinks}`));
  expect(seen.imagesWithoutWords === 0, about("has pictures that are broken or without words"));
  expect(seen.tablesWithoutCaption === 0, about("has tables without a caption"));
  expect(seen.overflow <= 0, about(`is ${seen.overflow} px wider than the window`));
  expect(seen.headings[0] === 1 && seen.headings.filter((level) => level === 1).length === 1,
         about("does not have exactly one first heading"));
  seen.headings.forEach((level, place) =>
    expect(place === 0 || level <= seen.headings[place - 1] + 1,
           about("skips a level of headings")));
  for (const chart of seen.charts) {
    const of = (text) => about(`${chart.id}: ${text}`);
    expect(chart.drawn === "true", of(`is not drawn: ${chart.drawn}`));
    expect(chart.marks > 0, of("is empty"));
    expect(chart.width > 100 && chart.height > 50, of(`is ${chart.width} x ${chart.height} px`));
    expect(chart.described, of("has no description"));
    expect(Math.abs(chart.scale - 1) < 0.01, of(`is drawn at a scale of ${chart.scale}`));
    expect(chart.labelledSelects, of("has a choice without a label"));
    expect(chart.ink === seen.ink, of(`has labels in ${chart.ink}, the page in ${seen.ink}`));
    expect(chart.rows > 0 && chart.tableRows === chart.rows,
           of(`has ${chart.tableRows} rows in its table, ${chart.rows} in its data`));
    expect(chart.caption !== "" && chart.columnHeadings > 1, of("has a table without headings"));
  }
}

async function drawn(page) {
  for (let waited = 0; waited < 120000; waited += 100) {
    if (await page.evaluate("document.body?.dataset.drawn === 'true'")) return;
    await new Promise((wake) => setTimeout(wake, 100));
  }
  throw new Error("the page is not drawn after two minutes");
}

// The page in pieces that can be looked at, and as it is printed.
async function takePictures(page, scheme) {
  const kPiecePx = 1600;
  const {cssContentSize: size} = await page.send("Page.getLayoutMetrics");
  for (let y = 0, piece = 0; y < size.height; y += kPiecePx, ++piece) {
    const height = Math.min(kPiecePx, size.height - y);
    const clip = {x: 0, y, width: size.width, height, scale: 1};
    const {data} = await page.send("Page.captureScreenshot", {clip, captureBeyondViewport: true});
    writeFileSync(`${options.pictures}/${scheme}-${piece}.png`, Buffer.from(data, "base64"));
  }
  const {data: pdf} = await page.send("Page.printToPDF", {preferCSSPageSize: true});
  writeFileSync(`${options.pictures}/${scheme}.pdf`, Buffer.from(pdf, "base64"));
}

async function open(page, width, scheme) {
  await page.send("Emulation.setDeviceMetricsOverride",
                  {width, height: 800, deviceScaleFactor: 1, mobile: false});
  await page.send("Emulation.setEmulatedMedia",
                  {features: [{name: "prefers-color-scheme", value: scheme}]});
  await page.send("Page.navigate", {url: pathToFileURL(resolve(path)).href});
  await drawn(page);
}

async function checkScheme(browser, scheme) {
  const page = await browser.newPage();
  browser.onEvent(({method, params, sessionId}) => {
    if (sessionId !== page.sessionId) return;
    if (method === "Runtime.exceptionThrown")
      failures.push(`${scheme}: ${params.exceptionDetails.exception?.description}`);
    if (method === "Runtime.consoleAPICalled" && /error|warning|assert/.test(params.type))
      failures.push(`${scheme}: ${params.args.map((a) => a.value ?? a.description).join(" ")}`);
    if (method === "Log.entryAdded" && params.entry.level === "error")
      failures.push(`${scheme}: ${params.entry.text}`);
    if (method === "Network.requestWillBeSent" && !/^(file|data|blob):/.test(params.request.url))
      failures.push(`${scheme}: asks for ${params.request.url}`);
  });
  for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
  await open(page, 1280, scheme);
  const seen = await page.evaluate(`(${survey})()`);
  checkSurvey(seen, scheme);
  console.log(`${scheme}: ${seen.charts.length} charts drawn in ${Math.round(seen.drawMs)} ms`);
  if (options.pictures) await takePictures(page, scheme);
  const unmoved = await page.evaluate(`(${pick})("figure.chart select")`);
  expect(unmoved.length === 0, `${scheme}: a pick does not change ${unmoved}`);
  if (await page.evaluate("!!document.querySelector('#setting')")) {
    const kept = await page.evaluate(`(${pick})("#setting select")`);
    expect(kept.length === 0, `${scheme}: another setting does not change ${kept}`);
  }
  return seen;
}

async function checkWindow(browser, width) {
  const page = await browser.newPage();
  await open(page, width, "light");
  checkSurvey(await page.evaluate(`(${survey})()`), `${width} px`);
  await page.evaluate(`(${watchPrinting})()`);
  await page.send("Page.printToPDF", {});
  for (const [summary, isOpen] of await page.evaluate("window.openOnPaper ?? []")) {
    const isFigures = !/^(Numbers|Libraries)/.test(summary);
    expect(isOpen === isFigures,
           `${width} px: "${summary}" is ${isOpen ? "open" : "closed"} on paper`);
  }
  expect(await page.evaluate("!!window.openOnPaper && !document.querySelector('details[open]:not(.drawing *)')"),
         `${width} px: stays open after it was printed`);
}

const browser = new Browser(options.chromium);
try {
  const light = await checkScheme(browser, "light");
  const dark = await checkScheme(browser, "dark");
  for (const width of [400, 1400]) await checkWindow(browser, width);
  expect(light.ink !== dark.ink && light.paper !== dark.paper, "light and dark look the same");
} finally {
  await browser.close();
}
for (const failure of failures) console.error(failure);
process.exitCode = failures.length > 0 ? 1 : 0;
