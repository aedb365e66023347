// Snapshots as bytes: magic, version, hash of the schema, hash of what follows; entity numbers, tables,
// resources. In the machine's own order of bytes.
#include <cstring>
#include <span>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/value_ops.h"

namespace lanthorn::ecs {
namespace {

constexpr std::string_view kMagic = "LANTSNAP";

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t header_size;
    std::uint64_t schema;
    std::uint64_t content;
};

void put(std::string& bytes, std::uint64_t number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class T>
void put_all(std::string& bytes, const std::vector<T>& values) {
    put(bytes, values.size());
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

bool take(std::span<const std::byte>& bytes, std::uint64_t& number) {
    if (bytes.size() < sizeof number) {
        return false;
    }
    std::memcpy(&number, bytes.data(), sizeof number);
    bytes = bytes.subspan(sizeof number);
    return true;
}

template <class T>
bool take_all(std::span<const std::byte>& bytes, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!take(bytes, count) || count > bytes.size() / sizeof(T)) {
        return false;
    }
    values.resize(count);
    if (count > 0) {
        std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    }
    bytes = bytes.subspan(count * sizeof(T));
    return true;
}

}  // namespace

std::string Snapshot::to_bytes() const {
    std::string content;
    put_all(content, numbers_.generations);
    put_all(content, numbers_.links);
    put_all(content, numbers_.pages);
    put(content, numbers_.next);
    put(content, numbers_.free_head);
    put(content, tables_.size());
    for (const Table& table : tables_) {
        std::vector<std::uint32_t> stored;
        for (std::size_t k = 0; k < registry_->components().size(); ++k) {
            if (!registry_->components()[k].opaque) {
                for (const SnapshotColumn& column : table.columns) {
                    if (&column.type() == &registry_->components()[k]) {
                        stored.push_back(static_cast<std::uint32_t>(k));
                    }
                }
            }
        }
        put_all(content, table.entities);
        put_all(content, stored);
        for (const std::uint32_t k : stored) {
            for (const SnapshotColumn& column : table.columns) {
                for (std::size_t i = 0;
                     &column.type() == &registry_->components()[k] && i < table.entities.size(); ++i) {
                    append_bytes(*column.type().value, column.row(i), Fields::all, content);
                }
            }
        }
    }
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        put(content, resources_[i] != nullptr ? 1 : 0);
        if (resources_[i] != nullptr) {
            append_bytes(*registry_->resources()[i].value, resources_[i].get(), Fields::all, content);
        }
    }
    Header header{};
    std::memcpy(header.magic, kMagic.data(), kMagic.size());
    header.version = kVersion;
    header.header_size = sizeof header;
    header.schema = registry_->schema_hash();
    header.content = XXH3_64bits(content.data(), content.size());
    return std::string(reinterpret_cast<const char*>(&header), sizeof header) + content;
}

bool Snapshot::read(std::span<const std::byte> bytes) {
    std::uint64_t next = 0;
    std::uint64_t free_head = 0;
    std::uint64_t tables = 0;
    if (!take_all(bytes, numbers_.generations) || !take_all(bytes, numbers_.links) ||
        !take_all(bytes, numbers_.pages) || !take(bytes, next) || !take(bytes, free_head) ||
        !take(bytes, tables)) {
        return false;
    }
    numbers_.next = static_cast<std::uint32_t>(next);
    numbers_.free_head = static_cast<std::uint32_t>(free_head);
    const auto& components = registry_->components();
    for (std::uint64_t t = 0; t < tables; ++t) {
        Table& table = tables_.emplace_back();
        std::vector<std::uint32_t> stored;
        if (!take_all(bytes, table.entities) || !take_all(bytes, stored)) {
            return false;
        }
        for (const std::uint32_t k : stored) {
            if (k >= components.size() || components[k].initial == nullptr) {
                return false;
            }
            SnapshotColumn& column = table.columns.emplace_back(components[k], table.entities.size());
            for (std::size_t i = 0; i < table.entities.size(); ++i) {
                column.append(components[k].initial.get(), 1);
                if (!read_bytes(*components[k].value, column.row(i), bytes)) {
                    return false;
                }
            }
        }
    }
    for (const ResourceType& type : registry_->resources()) {
        std::uint64_t present = 0;
        if (!take(bytes, present)) {
            return false;
        }
        resources_.push_back(present != 0 ? type.clone(type.initial.get()) : nullptr);
        if (present != 0 && !read_bytes(*type.value, resources_.back().get(), bytes)) {
            return false;
        }
    }
    return bytes.empty();
}

Snapshot Snapshot::from_bytes(std::string_view bytes, const Registry& registry, std::string_view source) {
    Header header{};
    if (bytes.size() < sizeof header || bytes.substr(0, kMagic.size()) != kMagic) {
        throw InputError(source, "", "is no snapshot, expected one that Lanthorn wrote");
    }
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.version != kVersion || header.header_size != sizeof header) {
        throw InputError(source, "",
                         "is a snapshot of version " + std::to_string(header.version) +
                             ", expected version " + std::to_string(kVersion));
    }
    if (header.schema != registry.schema_hash()) {
        throw InputError(source, "",
                         "is a snapshot of a program with other components, expected those of this one");
    }
    const std::string_view content = bytes.substr(sizeof header);
    Snapshot snapshot(registry);
    snapshot.stored_ = true;
    if (header.content != XXH3_64bits(content.data(), content.size()) ||
        !snapshot.read(std::as_bytes(std::span(content)))) {
        throw InputError(source, "", "is a damaged snapshot, expected it as it was written");
    }
    return snapshot;
}

}  // namespace lanthorn::ecs
