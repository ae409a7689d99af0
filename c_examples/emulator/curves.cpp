#include "curves.h"

#include <algorithm>

static const size_t CELLS = 2048;

static void join(Cell &cell, const Cell &next)
{
    cell = {std::min(cell.low, next.low), std::max(cell.high, next.high), next.last};
}

void Curves::add(double time_s, const Point &low, const Point &high, const Point &last)
{
    bool is_new = times_.empty() || points_ == stride_;
    if (is_new && times_.size() == CELLS) {
        halve();
        is_new = points_ == stride_;
    }
    if (is_new) {
        times_.push_back(time_s);
        cells_.emplace_back();
        points_ = 0;
    }
    for (int k = 0; k < CHANNELS; k++) {
        Cell next = {low[k], high[k], last[k]};
        is_new ? (void)(cells_.back()[k] = next) : join(cells_.back()[k], next);
    }
    times_.back() = time_s;
    points_++;
}

void Curves::halve()
{
    for (size_t k = 0; 2 * k < times_.size(); k++) {
        cells_[k] = cells_[2 * k];
        for (int channel = 0; channel < CHANNELS; channel++) {
            join(cells_[k][channel], cells_[2 * k + 1][channel]);
        }
        times_[k] = times_[2 * k + 1];
    }
    times_.resize(CELLS / 2);
    cells_.resize(CELLS / 2);
    stride_ *= 2;
    points_ = stride_;
}

std::vector<Cell> Curves::channel(int channel) const
{
    std::vector<Cell> result;
    for (const auto &cells : cells_) {
        result.push_back(cells[channel]);
    }
    return result;
}

std::vector<double> Curves::last(int channel) const
{
    std::vector<double> result;
    for (const auto &cells : cells_) {
        result.push_back(cells[(size_t)channel].last);
    }
    return result;
}
