// Words of the glossary (doc/explanation/concepts.md), explained where somebody points at them.

const kTerms = {
  "Neff": "Neff",
  "Effective number of particles": "Neff",
  "Unique ancestors": "ancestor",
  "Coalescence": "coalescence",
  "frontiers": "frontier",
  "graph of places G": "G",
  "path of the best particle s*": "s*",
  "particles": "particle",
  "loops": "closing",
  "recoveries": "recovery",
};

/** The text, with its explanation where the glossary has one. */
function term(text) {
  const meaning = kGlossary[kTerms[text]];
  return meaning ? element("span", { class: "term", title: meaning }, text) : text;
}
