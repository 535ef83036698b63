// SPDX-License-Identifier: MIT
#include "analysis/html/assets.h"

// The assembler takes the files as they are: a compiler would need minutes for a megabyte of text.
#define LANESCOPE_EMBED(name, path)                                   \
  __asm__(                                                            \
      ".pushsection .rodata\n"                                        \
      ".global lanescope_" #name                                      \
      "\n"                                                            \
      "lanescope_" #name                                              \
      ":\n"                                                           \
      ".incbin \"" path                                               \
      "\"\n"                                                          \
      ".global lanescope_" #name                                      \
      "_end\n"                                                        \
      "lanescope_" #name                                              \
      "_end:\n"                                                       \
      ".popsection\n");                                               \
  extern "C" const char lanescope_##name[], lanescope_##name##_end[]; \
  std::string_view lanescope::name() { return {lanescope_##name, lanescope_##name##_end}; }

LANESCOPE_EMBED(page_template, LANESCOPE_PAGE "/page.html")
LANESCOPE_EMBED(page_style, LANESCOPE_PAGE "/page.css")
LANESCOPE_EMBED(page_program, LANESCOPE_PAGE "/page.js")
LANESCOPE_EMBED(page_guide, LANESCOPE_GUIDE)
LANESCOPE_EMBED(vega, LANESCOPE_MODULES "/vega/build/vega.min.js")
LANESCOPE_EMBED(vega_lite, LANESCOPE_MODULES "/vega-lite/build/vega-lite.min.js")
LANESCOPE_EMBED(vega_embed, LANESCOPE_MODULES "/vega-embed/build/vega-embed.min.js")
LANESCOPE_EMBED(library_licences, LANESCOPE_LICENCES)
