// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#include "generated_texts.h"
#include "option_descriptions.h"

#include <sstream>

namespace {

namespace po = boost::program_options;

// So that a dash is one, and no line is taken for a request.
std::string to_roff(const std::string& text)
{
  std::string result;
  for(std::size_t i = 0; i < text.size(); ++i)
  {
    if((i == 0 || text[i - 1] == '\n') && (text[i] == '.' || text[i] == '\''))
      result += "\\&";
    if(text[i] == '-')
      result += '\\';
    result += text[i];
    if(text[i] == '\\')
      result += 'e';
  }
  return result;
}

// "weld|orient|none (=weld)"
std::string value_of(const po::option_description& option)
{
  return option.semantic()->max_tokens() > 0 ? option.format_parameter() : std::string();
}

} // namespace

std::string man_page()
{
  std::ostringstream os;
  os << ".TH CUT_LOCUS 1 \"\" \"" << to_roff(version().substr(0, version().find(','))) << "\"\n"
     << ".SH NAME\ncut_locus \\- cut loci of geodesic distances on triangle meshes\n"
     << ".SH SYNOPSIS\n.B cut_locus\n.I MESH\n[\\fIOPTION\\fR]...\n"
     << ".SH DESCRIPTION\n"
     << to_roff(purpose()) << "\n.SH OPTIONS\n";
  for(const auto& [caption, options] : option_groups())
  {
    os << ".SS " << caption << '\n';
    for(const auto& option : options.options())
      os << ".TP\n\\fB" << to_roff(option->format_name()) << "\\fR \\fI" << to_roff(value_of(*option)) << "\\fR\n"
         << to_roff(option->description()) << '\n';
  }
  const std::string examples = help().substr(help().find("Examples:\n") + 10);
  os << ".SH EXAMPLES\n.nf\n" << to_roff(examples) << ".fi\n";
  return os.str();
}

std::string bash_completion()
{
  std::ostringstream all, cases;
  for(const auto& group : option_groups())
    for(const auto& option : group.second.options())
    {
      all << " --" << option->long_name();
      std::string words;
      for(const std::string& word : choices(*option))
        words += (words.empty() ? "" : " ") + word;
      if(!words.empty())
        cases << "    --" << option->long_name() << ") words='" << words << "' ;;\n";
    }
  return R"(# bash completion for cut_locus; where no word fits, names of files are completed
_cut_locus()
{
  local words=
  case $3 in
)" + cases.str() +
         "    *) [[ $2 == -* ]] && words='" + all.str().substr(1) + R"(' ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$2"))
}
complete -o default -F _cut_locus cut_locus
)";
}
