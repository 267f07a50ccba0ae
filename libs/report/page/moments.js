// The list of moments to jump to, and their marks over the slider.

const kGroups = { decision: "decisions", detection: "loops", entry: "loops", end: "loops", recovery: "recoveries" };
const kKinds = { decision: "decision", detection: "loop detected", entry: "entry reached", end: "closing ended", recovery: "recovery" };

class Moments {
  constructor(replay, goTo) {
    this.replay = replay;
    this.items = replay.moments.map((moment) => this.item(moment, goTo));
    this.list = document.getElementById("moments");
    this.list.append(...this.items);
    this.hidden = new Set();
    this.count = document.getElementById("moments-count");
    if (!this.items.length) this.list.replaceWith(element("p", { class: "hint" }, "No loop was detected and nothing was decided in this run."));
    const last = Math.max(1, replay.steps.count - 1);
    this.ticks = replay.moments.map((moment) => element("i", { style: `--kind: var(--${moment.kind}); left: ${(100 * moment.step) / last}%` }));
    document.getElementById("ticks").append(...this.ticks);
    this.makeSwitches();
    this.filter();
  }

  /** A button for each group of moments, where there is more than one. */
  makeSwitches() {
    const kinds = [...new Set(this.replay.moments.map((m) => m.kind))];
    const groups = [...new Set(kinds.map((kind) => kGroups[kind]))];
    for (const group of groups.length > 1 ? groups : []) {
      const kind = kinds.find((k) => kGroups[k] === group);
      const button = element("button", { type: "button", "aria-pressed": "true", style: `--kind: var(--${kind})` }, term(group));
      button.addEventListener("click", () => {
        const hides = !this.hidden.delete(group);
        if (hides) this.hidden.add(group);
        button.setAttribute("aria-pressed", String(!hides));
        this.filter();
      });
      document.getElementById("moment-kinds").append(button);
    }
  }

  filter() {
    const shown = this.replay.moments.map((m) => !this.hidden.has(kGroups[m.kind]));
    shown.forEach((is, i) => (this.items[i].hidden = this.ticks[i].hidden = !is));
    const count = shown.filter((is) => is).length;
    this.count.textContent = count === shown.length ? String(count || "") : `${count} of ${shown.length}`;
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
