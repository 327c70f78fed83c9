// Copyright (c) 2026 The Surface_mesh_cut_locus authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Surface_mesh_cut_locus authors

#ifndef CGAL_CUT_LOCI_REFUSALS_H
#define CGAL_CUT_LOCI_REFUSALS_H

#include <CGAL/Cut_loci/Invalid_input.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace refusals {

/// what a function throws
inline std::string message_of(const std::function<void()>& function)
{
  try
  {
    function();
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}

inline void expect_has(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << '"' << part << "\" is not in \"" << text << '"';
}

/// each of `words` is in the message
inline void expect_words(const std::function<void()>& function, const std::vector<std::string>& words)
{
  const std::string message = message_of(function);
  for(const std::string& word : words)
    expect_has(message, word);
}

inline void expect_refused(const std::function<void()>& function, CGAL::Cut_loci::Cause cause,
                           const std::vector<std::string>& words = {})
{
  try
  {
    function();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch(const CGAL::Cut_loci::Invalid_input& error)
  {
    EXPECT_EQ(error.cause(), cause) << error.what();
  }
  expect_words(function, words);
}

} // namespace refusals

#endif // CGAL_CUT_LOCI_REFUSALS_H
