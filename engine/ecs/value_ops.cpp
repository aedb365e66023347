#include "engine/ecs/value_ops.h"

#include <cstring>

namespace lanthorn::ecs {
namespace {

const void* list_data(const ValueType& type, const void* list) {
    return type.data(const_cast<void*>(list));
}

// Runs of plain neighbours know of no author: such a structure is compared field by field.
bool equal_by_field(const ValueType& type, const void* a, const void* b, Fields fields) {
    for (const Field& field : type.fields) {
        if (is_among(field, fields) &&
            !equal(*field.type, at(a, field.offset), at(b, field.offset), fields)) {
            return false;
        }
    }
    return true;
}

const std::vector<ValueType::Step>& steps_of(const ValueType& type, Fields fields) {
    return fields == Fields::all ? type.all_steps : type.state_steps;
}

bool equal_lists(const ValueType& type, const void* a, const void* b, Fields fields) {
    const std::size_t count = type.count(a);
    if (count != type.count(b)) {
        return false;
    }
    if (count == 0) {
        return true;
    }
    const void* first_a = list_data(type, a);
    const void* first_b = list_data(type, b);
    if (type.element->plain && fields != Fields::author) {
        return std::memcmp(first_a, first_b, count * type.element->size) == 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!equal(*type.element, at(first_a, i * type.element->size), at(first_b, i * type.element->size),
                   fields)) {
            return false;
        }
    }
    return true;
}

void append_size(std::size_t count, std::string& bytes) {
    const std::uint64_t size = count;
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
}

bool take(std::span<const std::byte>& bytes, void* to, std::size_t count) {
    if (bytes.size() < count) {
        return false;
    }
    if (count > 0) {
        std::memcpy(to, bytes.data(), count);
    }
    bytes = bytes.subspan(count);
    return true;
}

bool take_plain(const ValueType& type, std::span<const std::byte>& bytes, void* to) {
    // A byte that is neither 0 nor 1 would be no bool.
    if (type.kind == ValueKind::boolean && !bytes.empty() && bytes[0] > std::byte{1}) {
        return false;
    }
    return take(bytes, to, type.size);
}

bool take_list(const ValueType& type, std::span<const std::byte>& bytes, void* list) {
    std::uint64_t count = 0;
    if (!take(bytes, &count, sizeof count) || (type.optional && count > 1) ||
        (type.fixed && count != type.count(list)) || count > bytes.size()) {
        return false;  // every element has a byte at least
    }
    type.resize(list, count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!read_bytes(*type.element, at(type.data(list), i * type.element->size), bytes)) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool is_among(const Field& field, Fields fields) {
    return fields == Fields::all || !(field.transient || (fields == Fields::author && field.runtime));
}

bool equal(const ValueType& type, const void* a, const void* b, Fields fields) {
    switch (type.kind) {
        case ValueKind::text:
            return *static_cast<const std::string*>(a) == *static_cast<const std::string*>(b);
        case ValueKind::list:
            return equal_lists(type, a, b, fields);
        case ValueKind::structure:
            if (fields == Fields::author) {
                return equal_by_field(type, a, b, fields);
            }
            for (const ValueType::Step& step : steps_of(type, fields)) {
                const bool same = step.type == nullptr
                                      ? std::memcmp(at(a, step.offset), at(b, step.offset), step.size) == 0
                                      : equal(*step.type, at(a, step.offset), at(b, step.offset), fields);
                if (!same) {
                    return false;
                }
            }
            return true;
        case ValueKind::opaque:
            return type.opaque_equal != nullptr && type.opaque_equal(a, b);
        default:
            return std::memcmp(a, b, type.size) == 0;
    }
}

void append_bytes(const ValueType& type, const void* value, Fields fields, std::string& bytes) {
    switch (type.kind) {
        case ValueKind::text: {
            const auto& text = *static_cast<const std::string*>(value);
            append_size(text.size(), bytes);
            bytes += text;
            break;
        }
        case ValueKind::list: {
            const std::size_t count = type.count(value);
            append_size(count, bytes);
            const void* first = count > 0 ? list_data(type, value) : nullptr;
            if (type.element->plain && count > 0) {
                bytes.append(static_cast<const char*>(first), count * type.element->size);
                break;
            }
            for (std::size_t i = 0; i < count; ++i) {
                append_bytes(*type.element, at(first, i * type.element->size), fields, bytes);
            }
            break;
        }
        case ValueKind::structure:
            for (const ValueType::Step& step : steps_of(type, fields)) {
                if (step.type == nullptr) {
                    bytes.append(static_cast<const char*>(at(value, step.offset)), step.size);
                } else {
                    append_bytes(*step.type, at(value, step.offset), fields, bytes);
                }
            }
            break;
        case ValueKind::opaque:
            break;
        default:
            bytes.append(static_cast<const char*>(value), type.size);
    }
}

bool read_bytes(const ValueType& type, void* value, std::span<const std::byte>& bytes) {
    switch (type.kind) {
        case ValueKind::text: {
            std::uint64_t size = 0;
            if (!take(bytes, &size, sizeof size) || size > bytes.size()) {
                return false;
            }
            static_cast<std::string*>(value)->assign(reinterpret_cast<const char*>(bytes.data()), size);
            bytes = bytes.subspan(size);
            return true;
        }
        case ValueKind::list:
            return take_list(type, bytes, value);
        case ValueKind::structure:
            for (const Field& field : type.fields) {
                if (!read_bytes(*field.type, at(value, field.offset), bytes)) {
                    return false;
                }
            }
            return true;
        case ValueKind::opaque:
            return true;
        default:
            return take_plain(type, bytes, value);
    }
}

void renumber_entities(const ValueType& type, void* value, const std::function<Entity(Entity)>& renumber) {
    if (!type.refers) {
        return;
    }
    if (type.kind == ValueKind::entity) {
        Entity& entity = *static_cast<Entity*>(value);
        entity = renumber(entity);
    } else if (type.kind == ValueKind::list) {
        const std::size_t count = type.count(value);
        for (std::size_t i = 0; i < count; ++i) {
            renumber_entities(*type.element, at(type.data(value), i * type.element->size), renumber);
        }
    } else if (type.kind == ValueKind::structure) {
        for (const Field& field : type.fields) {
            renumber_entities(*field.type, at(value, field.offset), renumber);
        }
    }
}

}  // namespace lanthorn::ecs
