#include "engine/replay/annotations.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/replay/recording_format.h"

namespace lanthorn::replay {

namespace {

using nlohmann::json;

std::string text_of(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json parsed(const Reader& reader, const Chunk& chunk) {
    return parse_json(chunk.body, fmt::format("{}: {} chunk at byte {}", reader.file(),
                                              letters_of(chunk.kind), chunk.begin));
}

Mark mark_of(const json& j) {
    return {j.at("step").get<std::uint64_t>(), j.at("name").get<std::string>(), j.value("camera", ""),
            j.value("aov", ""), j.value("tolerance", "")};
}

Ancestor ancestor_of(const json& j) {
    return {j.at("build").get<std::string>(), j.at("reason").get<std::string>(),
            j.at("roots").get<std::vector<std::uint64_t>>()};
}

StoredState state_of(const Reader& file, const Chunk& chunk) {
    Reader reader(file.file(), std::as_bytes(std::span(chunk.body)), chunk.begin);
    const auto step = reader.get<std::uint64_t>();
    return {step, chunk.body.substr(sizeof step)};
}

void read_json(const Reader& reader, const Chunk& chunk, Annotations& to) {
    const json body = parsed(reader, chunk);
    switch (chunk.kind) {
        case kMarkChunk:
            to.marks.push_back(mark_of(body));
            break;
        case kExpectationChunk:
            to.expectations.push_back(body.get<std::string>());
            break;
        case kNoteChunk:
            to.notes.push_back(body.get<std::string>());
            break;
        case kLogChunk:
            to.log.push_back(body.get<std::string>());
            break;
        default:
            to.line.push_back(ancestor_of(body));
    }
}

}  // namespace

std::string encoded_annotations(const Annotations& a, Packing packing) {
    std::string all;
    const auto add = [&](ChunkKind kind, const std::string& body) {
        if (body.size() <= kMostBody) {
            all += encoded_chunk(kind, body, packing, true);
        }
    };
    for (const std::string& line : a.log) {
        add(kLogChunk, text_of(line));
    }
    for (const std::string& line : a.notes) {
        add(kNoteChunk, text_of(line));
    }
    for (const std::string& line : a.expectations) {
        add(kExpectationChunk, text_of(line));
    }
    for (const Mark& m : a.marks) {
        add(kMarkChunk, text_of({{"step", m.step},
                                 {"name", m.name},
                                 {"camera", m.camera},
                                 {"aov", m.aov},
                                 {"tolerance", m.tolerance}}));
    }
    for (const StoredState& state : a.states) {
        Writer writer;
        writer.put(state.step);
        writer.put_bytes(std::string_view(state.bytes));
        add(kStateChunk, writer.text());
    }
    for (const Ancestor& one : a.line) {
        add(kLineChunk, text_of({{"build", one.build}, {"reason", one.reason}, {"roots", one.roots}}));
    }
    for (const UnknownPart& part : a.unknown) {
        add(static_cast<ChunkKind>(part.kind), part.body);
    }
    return all;
}

void read_annotation(const Reader& reader, const Chunk& chunk, Annotations& to) {
    switch (chunk.kind) {
        case kStateChunk:
            to.states.push_back(state_of(reader, chunk));
            break;
        case kMarkChunk:
        case kExpectationChunk:
        case kNoteChunk:
        case kLogChunk:
        case kLineChunk:
            try {
                read_json(reader, chunk, to);
            } catch (const json::exception&) {
                throw InputError(
                    reader.file(), fmt::format("byte {}", chunk.begin),
                    fmt::format("a {} chunk is not as docs/replay-format.md has it", letters_of(chunk.kind)));
            }
            break;
        default:
            if (!chunk.optional) {
                reader.fail(
                    fmt::format("found a chunk '{}', expected one that this version knows, or may pass "
                                "over: the file is of a later version",
                                letters_of(chunk.kind)));
            }
            to.unknown.push_back({static_cast<std::uint32_t>(chunk.kind), chunk.body});
    }
}

}  // namespace lanthorn::replay
