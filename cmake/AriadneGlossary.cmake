# cmake -D IN=concepts.md -D OUT=glossary.js -P AriadneGlossary.cmake: the glossary's table as an object of JavaScript, so that
# report.html explains words as the documents do.
file(READ "${IN}" text)
string(REGEX REPLACE "^.*\n## Glossary\n" "" text "${text}")
string(REGEX REPLACE "\n## .*$" "\n" text "${text}")
string(REPLACE "\\" "\\\\" text "${text}")
string(REPLACE "\"" "\\\"" text "${text}")
string(REPLACE "`" "" text "${text}")
string(REGEX REPLACE "\\[([^]\n]*)\\]\\([^)\n]*\\)" "\\1" text "${text}")
string(REGEX REPLACE "\n\\| term \\|[^\n]*\n\\|---[^\n]*" "" text "${text}")
string(REGEX REPLACE "\n\\| ([^|\n]+) \\| ([^|\n]+) \\|" "\n  \"\\1\": \"\\2\"," text "${text}")
string(REGEX REPLACE "\n+" "\n" text "${text}")
file(WRITE "${OUT}.new" "const kGlossary = {${text}};\n")
file(RENAME "${OUT}.new" "${OUT}")
