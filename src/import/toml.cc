// toml++ behind plain C.
#define TOML_EXCEPTIONS 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "value.h"

namespace {

int line_of(const toml::node &node) {
    return static_cast<int>(std::min<toml::source_index>(node.source().begin.line, INT_MAX));
}

value *add(memory_arena *arena, value *parent, value_kind kind, const std::string_view *key, const toml::node &node) {
    value *const added =
        value_add(arena, parent, kind, key ? key->data() : nullptr, key ? key->size() : 0, line_of(node));
    if (!added) throw std::bad_alloc();
    return added;
}

value *copy(memory_arena *arena, value *parent, const std::string_view *key, const toml::node &node, int depth);

/// toml++ keeps members by their names; a reader wants them as the file has them.
void copy_members(memory_arena *arena, value *to, const toml::table &table, int depth) {
    std::vector<std::pair<std::string_view, const toml::node *>> members;
    members.reserve(table.size());
    for (const auto &[key, node] : table) members.emplace_back(key.str(), &node);
    std::stable_sort(members.begin(), members.end(), [](const auto &one, const auto &other) {
        const toml::source_position a = one.second->source().begin, b = other.second->source().begin;
        return a.line != b.line ? a.line < b.line : a.column < b.column;
    });
    for (const auto &[key, node] : members) copy(arena, to, &key, *node, depth);
}

value *copy(memory_arena *arena, value *parent, const std::string_view *key, const toml::node &node, int depth) {
    if (depth > VALUE_MAX_DEPTH) throw std::length_error("");
    if (const toml::table *table = node.as_table()) {
        value *const made = add(arena, parent, VALUE_TABLE, key, node);
        copy_members(arena, made, *table, depth + 1);
        return made;
    }
    if (const toml::array *list = node.as_array()) {
        value *const made = add(arena, parent, VALUE_LIST, key, node);
        for (const toml::node &item : *list) copy(arena, made, nullptr, item, depth + 1);
        return made;
    }
    if (const toml::value<std::string> *text = node.as_string()) {
        value *const made = add(arena, parent, VALUE_TEXT, key, node);
        if (!value_set_text(arena, made, text->get().data(), text->get().size())) throw std::bad_alloc();
        return made;
    }
    const bool truth = node.is_boolean(), number = node.is_number();
    value *const made = add(arena, parent, truth ? VALUE_TRUTH : number ? VALUE_NUMBER : VALUE_DATE, key, node);
    if (truth) made->number = node.as_boolean()->get() ? 1.0 : 0.0;
    if (number)
        made->number =
            node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
    return made;
}

/// Where a file is no TOML, in the library's words.
whirl_status refuse(const char *name, const toml::parse_error &error) {
    std::string said(error.description());
    whirl_make_plain(said.data());
    return whirl_fail(WHIRL_BAD_INPUT, "%.120s:%u: is no TOML: %.200s", name,
                      static_cast<unsigned>(error.source().begin.line), said.c_str());
}

} // namespace

extern "C" whirl_status value_read_toml(memory_arena *arena, const char *text, size_t length, const char *name,
                                        value **root) {
    *root = nullptr;
    try {
        const toml::table table = toml::parse(std::string_view(text, length));
        *root = copy(arena, nullptr, nullptr, table, 0);
        return whirl_ok();
    } catch (const toml::parse_error &error) {
        return refuse(name, error);
    } catch (const std::length_error &) {
        return whirl_fail(WHIRL_BAD_INPUT, "%.120s: has more than %d lists or tables within each other", name,
                          static_cast<int>(VALUE_MAX_DEPTH));
    } catch (...) { // it throws nothing else but where memory is lacking
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", name);
    }
}
