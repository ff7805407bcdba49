#include "datapath/error.h"

namespace bump {

std::string to_string(const Location& where) {
  std::string text = where.file;
  if (where.line > 0) text += ":" + std::to_string(where.line);
  if (where.line > 0 && where.column > 0) text += ":" + std::to_string(where.column);
  return text;
}

namespace {

std::string compose(const ErrorText& text) {
  std::string message;
  if (!text.where.file.empty()) message += to_string(text.where) + ": ";
  message += text.what;
  if (!text.why.empty()) message += "\n  why: " + text.why;
  if (!text.try_this.empty()) message += "\n  try: " + text.try_this;
  return message;
}

}  // namespace

Error::Error(ErrorKind kind, ErrorText text) : std::runtime_error(compose(text)), kind_(kind), text_(std::move(text)) {}

}  // namespace bump
