#include "testbench/experiments/svg_text.h"

namespace bump {

namespace {

/// Bytes of the UTF-8 sequence at `at`, 0 if there is none.
std::size_t sequence_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned lead = byte(at);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (byte(at + i) < 0x80 || byte(at + i) >= 0xC0) return 0;
  if (length == 1) return 1;
  const unsigned second = byte(at + 1);
  // Longer than needed, halves of surrogate pairs, beyond the last code point.
  const bool wrong = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) || (lead == 0xF0 && second < 0x90) ||
                     (lead == 0xF4 && second >= 0x90);
  return wrong ? 0 : length;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text, at);
    const char c = text[at];
    if (length == 0)
      escaped += '?';
    else if (length > 1)
      escaped += text.substr(at, length);
    else if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c >= 0 && c < 0x20 ? ' ' : c;
    at += length == 0 ? 1 : length;
  }
  // U+FFFE and U+FFFF are UTF-8 but no characters of XML.
  for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t at = escaped.find(none); at != std::string::npos; at = escaped.find(none)) escaped.replace(at, 3, "?");
  return escaped;
}

}  // namespace bump
