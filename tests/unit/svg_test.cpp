// Drawings of gnuplot within a page: smaller, and the same to the eye.
#include "validation/page/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "validation/page/svg_file.h"
#include "validation/page/svg_path.h"

namespace furrow::validation {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string drawing(const std::string& body) {
  return "<?xml version=\"1.0\"?>\n<svg \n width=\"600\" height=\"300\"\n viewBox=\"0 0 600 "
         "300\"\n>\n<title>Gnuplot</title>\n<!-- a > b -->\n"
         "<g id=\"gnuplot_canvas\">\n<defs>\n<circle id='gpDot' r='0.5'/>\n</defs>\n" +
         body + "</g>\n</svg>\n";
}

std::string group(const std::string& body, const std::string& color = "black") {
  return "<g fill=\"none\" color=\"" + color +
         "\" stroke=\"currentColor\" stroke-width=\"2.00\" stroke-linecap=\"butt\">\n" + body + "</g>\n";
}

TEST(Svg, ShortNumbersSayTheSameToATenth) {
  EXPECT_EQ(short_number(12.34), "12.3");
  EXPECT_EQ(short_number(12.0), "12");
  EXPECT_EQ(short_number(0.46), ".5");
  EXPECT_EQ(short_number(-0.46), "-.5");
  EXPECT_EQ(short_number(-0.01), "0");
  EXPECT_EQ(short_number(120), "120");
  EXPECT_EQ(short_numbers("translate(1.26,-3.00) scale(2.816)", 2), "translate(1.26,-3) scale(2.82)");
}

// By hand: steps are those between rounded places.
TEST(Svg, APathIsStepsBetweenRoundedPlaces) {
  EXPECT_EQ(short_path("M10.04,20.04 L10.09,19.96 L30,40 "), "M10 20l.1 0 19.9 20");
  EXPECT_EQ(short_path("M0,0 L1,0 L1,1 Z M5,5 L6,6"), "M0 0l1 0 0 1zM5 5l1 1");
  EXPECT_EQ(short_path("M3,4"), "") << "no line";
  EXPECT_EQ(closed_path("0,0 1,0\n1,1 "), "M0 0l1 0 0 1z");
}

TEST(Svg, ALongLineKeepsItsPeaksAndLosesWhatNoEyeMisses) {
  std::string d = "M0,100";
  for (int k = 1; k <= 1000; ++k) d += " L" + std::to_string(k) + "," + (k == 500 ? "0" : "100");
  const std::string less = short_path(d);
  EXPECT_EQ(less, "M0 100l499 0 1-100 1 100 499 0");
}

// What is faint in a chart stays so in the page: lines, dots, other marks.
TEST(Svg, WhatIsFaintStaysFaint) {
  const std::string
      line = "\t<path stroke='rgb(  0, 114, 178)' opacity='0.40'  d='M1,2 L3,4  '/>",
      dot = "\t<use xlink:href='#gpPt6' transform='translate(10,20) scale(2.00)' color='rgb(1, 2, 3)' opacity='0.40'/>",
      mark =
          "\t<use xlink:href='#gpPt2' transform='translate(10,20) scale(2.00)' color='rgb(1, 2, 3)' opacity='0.40'/>";
  for (const std::string& faint : {line, dot, mark}) {
    const std::string svg = compacted(drawing(group(faint)), "x", "faint");
    EXPECT_TRUE(has(svg, " opacity=\".4\"")) << svg;
    std::string whole = faint;
    whole.erase(whole.find(" opacity='0.40'"), 15);
    EXPECT_FALSE(has(compacted(drawing(group(whole)), "x", "whole"), "opacity")) << whole;
  }
  const std::string both =
      compacted(drawing(group(dot + "\n" + dot.substr(0, dot.find(" opacity")) + "/>\n")), "x", "x");
  EXPECT_TRUE(has(both, "stroke=\"#010203\" opacity=\".4\"") && has(both, "stroke=\"#010203\" stroke-width")) << both;
}

TEST(Svg, LinesKeepColourWidthAndDashes) {
  const std::string svg = compacted(
      drawing(group("\t<path stroke='rgb(  0, 114, 178)' stroke-dasharray='2,4'  d='M1,2 L3,4  '/>")), "x", "a line");
  EXPECT_TRUE(has(svg, "stroke=\"#0072b2\"") && has(svg, "stroke-width=\"2\"") && has(svg, "stroke-dasharray=\"2,4\""))
      << svg;
  EXPECT_TRUE(has(svg, "M1 2l2 2")) << svg;
  EXPECT_TRUE(has(svg, "viewBox=\"0 0 600 300\"") && has(svg, "aria-label=\"a line\"")) << svg;
}

TEST(Svg, BlackIsTheColourOfTheTextAround) {
  const std::string svg = compacted(drawing(group("<path stroke='black'  d='M1,2 L3,4'/>")), "x", "");
  EXPECT_TRUE(has(svg, "stroke=\"currentColor\"")) << svg;
  EXPECT_FALSE(has(svg, "black")) << svg;
}

TEST(Svg, FilledMarksAreEndsOfLinesAndOthersKeepTheirShape) {
  const std::string svg = compacted(
      drawing(group("<use xlink:href='#gpPt6' transform='translate(10.00,20.00) scale(3.00)' color='rgb(255, 0, 0)'/>"
                    "<use xlink:href='#gpPt6' transform='translate(30.00,20.00) scale(3.00)' color='rgb(255, 0, 0)'/>"
                    "<use xlink:href='#gpPt5' transform='translate(1.00,2.00) scale(3.00)' color='rgb(255, 0, 0)'/>")),
      "x", "");
  EXPECT_TRUE(has(svg, "stroke-width=\"6\" stroke-linecap=\"round\" d=\"M10 20h0M30 20h0\"")) << svg;
  // 0.33 times the scale of 3 is 1, 0.67 is 2, to a hundredth of a pixel.
  EXPECT_TRUE(has(svg, "transform=\"scale(3)\"><use href=\"#gpPt5\" x=\".33\" y=\".67\"/></g>")) << svg;
}

TEST(Svg, ADiscWithARimIsOneCircle) {
  const std::string svg = compacted(
      drawing(
          group("<use xlink:href='#gpPt6' transform='translate(10.00,20.00) scale(9.00)' color='rgb(128, 128, 128)'/>"
                "<use xlink:href='#gpPt6' transform='translate(10.00,20.00) scale(8.00)' color='rgb(0, 0, 255)'/>")),
      "x", "");
  EXPECT_TRUE(has(svg, "<circle cx=\"10\" cy=\"20\" r=\"8.5\" fill=\"#0000ff\"/>")) << svg;
  EXPECT_TRUE(has(svg, "stroke=\"#808080\" stroke-width=\"1\"")) << svg;
}

TEST(Svg, WordsStayWhereTheyAre) {
  const std::string svg =
      compacted(drawing(group("<g transform=\"translate(70.65,378.46)\" stroke=\"none\" fill=\"black\" "
                              "font-family=\"sans-serif\" font-size=\"15.00\" text-anchor=\"end\">\n"
                              "<text><tspan font-family=\"sans-serif\" >a &lt; 10</tspan><tspan font-size=\"12.0\" "
                              "dy=\"-7.50px\">6</tspan></text>\n</g>")),
                "x", "");
  EXPECT_TRUE(has(svg, "x=\"70.7\" y=\"378.5\"") || has(svg, "x=\"70.6\" y=\"378.5\"")) << svg;
  EXPECT_TRUE(has(svg, "a &lt; 10<tspan font-size=\"12.0\" dy=\"-7.50px\">6</tspan>") &&
              has(svg, "text-anchor=\"end\""))
      << svg;
}

TEST(Svg, TitlesOfGnuplotAreDroppedThoseOfTheScriptStay) {
  const std::string line = group("<path stroke='black' d='M1,2 L3,4'/>");
  const std::string svg = compacted(drawing("<g id=\"gnuplot_plot_1\" ><title>$curves using 1:2</title>\n" + line +
                                            "</g>\n<g id=\"gnuplot_plot_2\" ><title>rk4</title>\n" + line + "</g>\n"),
                                    "x", "");
  EXPECT_FALSE(has(svg, "using")) << svg;
  EXPECT_TRUE(has(svg, "<title>rk4</title>")) << svg;
  EXPECT_FALSE(has(svg, "Gnuplot")) << svg;
}

TEST(Svg, AFileIsTitledByWhatItShowsAndItsPartsOnlyWhereTheySaySomething) {
  const std::string file = as_file(drawing("<g id=\"gnuplot_plot_1\" ><title>gnuplot_plot_1</title></g><g "
                                           "id=\"gnuplot_plot_2\" ><title>rk4</title></g>"),
                                   "speed", "CPU time < 1 s");
  EXPECT_TRUE(has(file, "<title>CPU time &lt; 1 s</title>")) << file;
  EXPECT_TRUE(has(file, "<g id=\"speed_plot_2\" ><title>rk4</title></g>")) << file;
  EXPECT_FALSE(has(file, "nuplot</title>") || has(file, "gnuplot_plot")) << file;
}

TEST(Svg, AFileHasAMarginForWordsAtTheEdge) {
  const std::string file = as_file(drawing(""), "speed", "CPU time");
  EXPECT_TRUE(has(file, "width=\"624\" height=\"316\"\n viewBox=\"-12 -8 624 316\"\n>")) << file;
}

TEST(Svg, OneThatIsCutShortIsAnError) { EXPECT_THROW(compacted("<svg width=\"1\"><g>", "x", ""), std::runtime_error); }

}  // namespace
}  // namespace furrow::validation
