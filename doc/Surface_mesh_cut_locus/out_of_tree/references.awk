# Makes of a BibTeX file with one field per line
#   -v output=page     a Doxygen page with the references, in the order of the authors as they are written
#   -v output=filter   a sed script that turns \cgalCite{key} into a link to the page; the keys are numbered in the same
#                      order
function value(line) {
  sub(/^[^{]*\{/, "", line)
  sub(/\},?[ \t]*$/, "", line)
  gsub(/\{\\"o\}/, "\\&ouml;", line)
  gsub(/\{\\'e\}/, "\\&eacute;", line)
  gsub(/\{\\c c\}/, "\\&ccedil;", line)
  gsub(/\{\\ae\}/, "\\&aelig;", line)
  gsub(/[{}]/, "", line)
  gsub(/--/, "\\&ndash;", line)
  return line
}
function label(key) {
  gsub(/[^A-Za-z0-9]/, "_", key)
  return "reference_" key
}
/^@/ {
  key = $0
  sub(/^@[a-z]+\{/, "", key)
  sub(/,[ \t]*$/, "", key)
  keys[++count] = key
}
/^[ \t]+[a-z]+ = \{/ { field[key, $1] = value($0) }
END {
  for(i = 2; i <= count; ++i) {
    moved = keys[i]
    for(j = i - 1; j > 0 && last_name(keys[j]) > last_name(moved); --j)
      keys[j + 1] = keys[j]
    keys[j + 1] = moved
  }
  if(output == "page") {
    print "/*!\n\\page references References\n\nWhat the manual cites.\n"
    for(i = 1; i <= count; ++i)
      printf "\\anchor %s\n<b>[%d]</b> %s.\n\n", label(keys[i]), i, reference(keys[i])
    print "*/"
  } else
    for(i = 1; i <= count; ++i)
      printf "s/[\\\\@]cgalCite{%s}/\\\\ref %s \"[%d]\"/g\n", keys[i], label(keys[i]), i
}
function last_name(key,   names, words, n) {
  split(field[key, "author"], names, " and ")
  n = split(names[1], words, " ")
  return words[n] " " field[key, "year"]
}
function reference(key,   text, names) {
  names = field[key, "author"]
  gsub(/ and /, ", ", names)
  text = names ". " field[key, "title"] ". "
  if(field[key, "journal"] != "")
    text = text "<em>" field[key, "journal"] "</em>, " field[key, "volume"] \
           (field[key, "number"] != "" ? "(" field[key, "number"] ")" : "") ":" field[key, "pages"] ", "
  else if(field[key, "booktitle"] != "")
    text = text "In <em>" field[key, "booktitle"] "</em>, pages " field[key, "pages"] ", "
  else
    text = text field[key, "publisher"] field[key, "institution"] ", "
  if(field[key, "booktitle"] != "" && field[key, "publisher"] != "")
    text = text field[key, "publisher"] ", "
  return text field[key, "year"]
}
