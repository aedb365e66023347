#include "game/presentation/album/page.h"

#include <cctype>

#include "lanthorn/core/printable.h"

namespace lanthorn::game {

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>lamplighter: the tour</title>
<style>
body { margin: 0 auto; padding: 2em 1.2em; max-width: 84em; background: #15100c; color: #e9dcc3;
       font: 1.05em/1.5 Cabin, "Segoe UI", sans-serif; }
h1, h2 { font-family: Quattrocento, Georgia, serif; font-weight: normal; color: #ffcf87; }
h1 { margin: 0; font-size: 2.6em; }
h2 { margin: 2em 0 0; }
p { margin: 0.3em 0 1em; color: #a8977a; }
figure { margin: 0; }
img { display: block; width: 100%; height: auto; border-radius: 4px; }
figcaption { padding: 0.3em 0; color: #a8977a; }
.moving { max-width: 60em; }
.stills { display: grid; gap: 1em; grid-template-columns: repeat(auto-fit, minmax(19em, 1fr)); }
</style>
<h1>lamplighter</h1>
)";

// A file's name as a relative reference (RFC 3986): what could be read as anything else is written %41.
std::string uri(const std::string& file) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string out;
    for (const char c : file) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && (std::isalnum(byte) != 0 || c == '-' || c == '.' || c == '_' || c == '~')) {
            out += c;
        } else {
            out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
        }
    }
    return out;
}

std::string figure(const std::string& file, const std::string& alternative, const std::string& caption) {
    std::string out = "<figure><img src=\"" + uri(file) + "\" alt=\"" + markup_text(alternative) + "\">";
    if (!caption.empty()) {
        out += "<figcaption>" + markup_text(caption) + "</figcaption>";
    }
    return out + "</figure>\n";
}

}  // namespace

std::string page(const Album& album) {
    std::string out = kHead;
    out += "<p>" + markup_text(album.words) + "</p>\n";
    if (!album.moving.empty()) {
        out += "<div class=\"moving\">\n" + figure(album.moving, "All levels, one after another", "") +
               "</div>\n";
    }
    for (const AlbumLevel& level : album.levels) {
        out += "<h2>" + markup_text(level.title) + "</h2>\n<p>" + markup_text(level.words) +
               "</p>\n<div class=\"stills\">\n";
        for (const AlbumPicture& picture : level.pictures) {
            out += figure(picture.file, level.title + ": " + picture.words, picture.words);
        }
        out += "</div>\n";
    }
    return out + "</html>\n";
}

}  // namespace lanthorn::game
