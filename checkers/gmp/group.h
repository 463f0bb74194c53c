// SPDX-License-Identifier: Apache-2.0
// Sorting by small whole numbers.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

// Sorts by key(item) < keys, items of one key in the order that they had. The first item of each key, and the end.
template <class Item, class Key>
std::vector<std::size_t> groupByKey(std::vector<Item>& items, std::size_t keys, const Key& key) {
    std::vector<std::size_t> first(keys + 1, 0);
    for (const Item& item : items) ++first[key(item) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Item> grouped(items.size());
    std::vector<std::size_t> next = first;
    for (const Item& item : items) grouped[next[key(item)]++] = item;
    items = std::move(grouped);
    return first;
}
