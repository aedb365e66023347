#include "engine/assets/image_format.h"

#include <algorithm>
#include <iterator>

namespace lanthorn {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    std::size_t offset;
    std::string_view format;
};

constexpr Signature kSignatures[] = {
    {"\x76\x2f\x31\x01"sv, 0, "openexr"},
    {"#?"sv, 0, "hdr"},
    {"II*\0"sv, 0, "tiff"},
    {"MM\0*"sv, 0, "tiff"},
    {"II+\0"sv, 0, "tiff"},
    {"MM\0+"sv, 0, "tiff"},
    {"DDS "sv, 0, "dds"},
    {"8BPS"sv, 0, "psd"},
    {"SDPX"sv, 0, "dpx"},
    {"XPDS"sv, 0, "dpx"},
    {"BM"sv, 0, "bmp"},
    {"GIF8"sv, 0, "gif"},
    {"P1"sv, 0, "pnm"},
    {"P2"sv, 0, "pnm"},
    {"P3"sv, 0, "pnm"},
    {"P4"sv, 0, "pnm"},
    {"P5"sv, 0, "pnm"},
    {"P6"sv, 0, "pnm"},
    {"PF"sv, 0, "pnm"},
    {"Pf"sv, 0, "pnm"},
    {"\x01\xda"sv, 0, "sgi"},
    {"FOR4"sv, 0, "iff"},
    {"\x53\x80\xf6\x34"sv, 0, "softimage"},
    {"\x80\x2a\x5f\xd7"sv, 0, "cineon"},
    {"SIMPLE  ="sv, 0, "fits"},
    {"\0\0\1\0"sv, 0, "ico"},
    {"\0\0\0\x0cjP  "sv, 0, "jpeg2000"},
    {"\xff\x4f\xff\x51"sv, 0, "jpeg2000"},
    {"ftyp"sv, 4, "heif"},
    {"TRUEVISION-XFILE.\0"sv, std::string_view::npos, "targa"},  // at the end
};

struct Ending {
    std::string_view ending, format;
};

constexpr Ending kNamed[] = {{".tga", "targa"}, {".tpic", "targa"},  {".rla", "rla"},
                             {".z", "zfile"},   {".zfile", "zfile"}, {".dcm", "dicom"}};
// Most have a TIFF's signature.
constexpr std::string_view kRaw[] = {".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dcr", ".dng", ".erf",
                                     ".iiq", ".kdc", ".mef", ".mos", ".mrw", ".nef", ".nrw", ".orf",
                                     ".pef", ".raf", ".raw", ".rw2", ".sr2", ".srf", ".srw", ".x3f"};

struct Written {
    std::string_view ending;
    WrittenFormat format;
};
constexpr Written kWritten[] = {
    {".hdr", {"hdr", true}},  {".tif", {"tiff", true}},   {".tiff", {"tiff", true}},
    {".bmp", {"bmp", false}}, {".dpx", {"dpx", false}},   {".gif", {"gif", false}},
    {".iff", {"iff", false}}, {".jpg", {"jpeg", false}},  {".jpeg", {"jpeg", false}},
    {".ppm", {"pnm", false}}, {".tga", {"targa", false}}, {".webp", {"webp", false}}};

bool has(std::string_view text, const Signature& signature) {
    if (signature.offset == std::string_view::npos) {
        return text.ends_with(signature.bytes);
    }
    if (text.size() < signature.offset || !text.substr(signature.offset).starts_with(signature.bytes)) {
        return false;
    }
    // Two letters begin many a text.
    return (signature.format != "bmp" ||
            text.substr(std::min<std::size_t>(text.size(), 6)).starts_with("\0\0\0\0"sv)) &&
           (signature.format != "pnm" ||
            (text.size() > 2 && (text[2] == '\n' || text[2] == ' ' || text[2] == '\r')));
}

}  // namespace

std::string_view format_to_read(std::span<const std::uint8_t> bytes, std::string_view ending) {
    if (std::ranges::find(kRaw, ending) != std::end(kRaw)) {
        return "raw";
    }
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto* const signature =
        std::ranges::find_if(kSignatures, [&](const Signature& s) { return has(text, s); });
    if (signature != std::end(kSignatures)) {
        return signature->format;
    }
    const auto* const named = std::ranges::find(kNamed, ending, &Ending::ending);
    return named != std::end(kNamed) && !bytes.empty() ? named->format : std::string_view();
}

WrittenFormat format_to_write(std::string_view ending) {
    const auto* const found = std::ranges::find(kWritten, ending, &Written::ending);
    return found != std::end(kWritten) ? found->format : WrittenFormat();
}

}  // namespace lanthorn
