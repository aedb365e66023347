// The page that shows a tour's pictures: one HTML file beside them, without scripts or anything from
// elsewhere.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::game {

struct AlbumPicture {
    std::string file;  // beside the page
    std::string words;
};

struct AlbumLevel {
    std::string title;
    std::string words;  // how it went
    std::vector<AlbumPicture> pictures;
};

struct Album {
    std::string moving;  // the animated picture's file; empty: there is none
    std::string words;   // how the pictures were made
    std::vector<AlbumLevel> levels;
};

// HTML 5, UTF-8. Titles and words may hold any characters.
std::string page(const Album& album);

}  // namespace lanthorn::game
