// Puts the page together.

function fillText(run, view) {
  document.querySelector("h1").textContent = document.title;
  for (const [name, value] of run.facts) {
    byId("facts").append(html("div", {}, html("dt", {}, name), html("dd", {}, value)));
  }
  if (run.per_point > 1) {
    byId("points").textContent = `The run is too long to keep every sample: a point is the least and the greatest of ${run.per_point} samples.`;
  }
  const fill = (name, items) => {
    byId(`${name}-section`).hidden = items.length === 0;
    byId(name).append(...items.map((item) => html("li", {}, ...item)));
  };
  fill("faults", run.faults.map(([time, text]) => [moment(view, time), ` ${text}`]));
  fill("notes", run.notes.map((note) => [note]));
  byId("output-section").hidden = run.output.length === 0;
  byId("programs-section").hidden = run.programs.length === 0;
  if (run.resolution > 0) {
    byId("resolution").hidden = false;
    byId("resolution").textContent =
      `The run is too long to keep every statement: what is shown is right to within ${seconds(run.resolution)}.`;
  }
}

function showNumbers(view) {
  const span = view.to - view.from;
  byId("range").textContent = `${seconds(view.from)} to ${seconds(view.to)} (${seconds(span)})`;
  const at = byId("at");
  if (document.activeElement !== at) {
    at.value = String(Number(view.cursor.toFixed(6)));
  }
  document.querySelectorAll(".cursor-time").forEach((element) => (element.textContent = seconds(view.cursor)));
}

function start() {
  const run = readRun();
  const view = new View(run.begin, run.end);
  const plots = byId("plots");
  const panels = makePanels(run);
  plots.append(...panels.map((panel) => panel.element));
  if (panels.length === 0) {
    plots.append(html("p", {}, "No signal was recorded; --signals names those that are."));
    byId("plots-help").hidden = true;
  }
  const paths = run.paths.map((data) => new Path(data)).filter((path) => path.moves());
  byId("paths").append(...paths.map((path) => path.element));
  byId("paths-section").hidden = paths.length === 0;
  const programs = run.programs.map((data) => new Program(data, run.files));
  byId("programs").append(...programs.map((program) => program.element));
  const output = new Output(run.output, view);
  fillText(run, view);

  const widthOf = (element) => Math.max(Math.round(element.getBoundingClientRect().width), 240);
  const draw = () => {
    panels.forEach((panel) => panel.draw(view, widthOf(panel.svg)));
    panels.forEach((panel) => panel.readout(view.cursor));
    paths.forEach((path) => path.draw(view, widthOf(path.svg)));
    programs.forEach((program) => program.draw(view.cursor));
    output.draw();
    showNumbers(view);
  };
  connect(view, plots, () => ({ left: panels[0].svg.getBoundingClientRect().left, scale: panels[0].time }));
  view.follow(draw);
  window.addEventListener("resize", draw);
  // What is printed is drawn for the width of the paper.
  window.matchMedia("print").addEventListener("change", draw);
  document.querySelector("main").dataset.ready = "true";
}

start();
