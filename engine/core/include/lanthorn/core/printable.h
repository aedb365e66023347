// Text that strangers wrote, made fit to be shown: on a terminal, in a log, in one line, on a page.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lanthorn {

// Bytes of the UTF-8 character that begins at `text[at]`; 0 if none does (RFC 3629: no overlong forms, no
// surrogates, nothing above U+10FFFF).
std::size_t utf8_character(std::string_view text, std::size_t at);

// `text` with all that a terminal would obey, and bytes that are no UTF-8, written out: \n, \t, \x1b. Those
// are the control characters (C0, DEL, C1) and the marks that turn the direction of text (\u202e).
std::string printable(std::string_view text);

// `text` within XML or HTML, in an element or an attribute: &, <, >, " and ' written out, and "?" for what no
// XML may hold, control characters and bytes that are no UTF-8.
std::string markup_text(std::string_view text);

// `text` if it is at most `most` bytes, else its beginning and "...", together at most that many. No
// character of UTF-8 is cut. `most` is at least 3.
std::string shortened(std::string_view text, std::size_t most);

// The same of its end: "..." and the rest, as of a path, whose end says more.
std::string shortened_front(std::string_view text, std::size_t most);

}  // namespace lanthorn
