// The list of moments to jump to, and their marks over the slider.

const kKinds = { decision: "decision", detection: "loop detected", entry: "entry reached", end: "closing ended", recovery: "recovery" };

class Moments {
  constructor(replay, goTo) {
    this.replay = replay;
    this.items = replay.moments.map((moment) => this.item(moment, goTo));
    this.list = document.getElementById("moments");
    this.list.append(...this.items);
    document.getElementById("moments-count").textContent = this.items.length ? String(this.items.length) : "";
    if (!this.items.length) this.list.replaceWith(element("p", { class: "hint" }, "No loop was detected and nothing was decided in this run."));
    const last = Math.max(1, replay.steps.count - 1);
    for (const moment of replay.moments)
      document.getElementById("ticks").append(element("i", { style: `--kind: var(--${moment.kind}); left: ${(100 * moment.step) / last}%` }));
  }

  item(moment, goTo) {
    const button = element("button", { type: "button" });
    button.append(element("span", { class: "when" }, `${clock(this.replay.steps.time[moment.step])} · update ${moment.step} · ${kKinds[moment.kind]}`));
    button.append(element("span", { class: "what" }, moment.title));
    if (moment.text) button.append(element("span", { class: "more" }, moment.text));
    button.addEventListener("click", () => goTo(moment.step));
    const item = element("li", { style: `--kind: var(--${moment.kind})` }, button);
    if (moment.table.length) item.append(element("details", {}, element("summary", {}, "Details"), element("div", { class: "scroll" }, this.table(moment.table))));
    return item;
  }

  table([head, ...rows]) {
    const row = (tag, cells) => element("tr", {}, ...cells.map((c) => element(tag, {}, c)));
    return element("table", {}, element("thead", {}, row("th", head)), element("tbody", {}, ...rows.map((r) => row("td", r))));
  }

  /** Marks the last moment that is not after the step. */
  show(step) {
    const now = this.replay.moments.filter((m) => m.step <= step).length - 1;
    if (now === this.now) return;
    this.now = now;
    this.items.forEach((item, i) => {
      item.classList.toggle("now", i === now);
      if (i === now) item.firstChild.setAttribute("aria-current", "true");
      else item.firstChild.removeAttribute("aria-current");
    });
    // Within the list only: the page itself must not move while it plays.
    if (now >= 0) {
      const { offsetTop, offsetHeight } = this.items[now];
      const { scrollTop, clientHeight } = this.list;
      if (offsetTop < scrollTop || offsetTop + offsetHeight > scrollTop + clientHeight) this.list.scrollTop = offsetTop - clientHeight / 3;
    }
  }
}
