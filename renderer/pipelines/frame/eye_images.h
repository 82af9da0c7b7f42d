#pragma once
#include <array>

#include "renderer/effects/memory.h"
#include "renderer/kernels/merge.h"
#include "renderer/kernels/mesh_facing.h"
#include "renderer/kernels/resampling.h"
#include "renderer/pipelines/frame/eye_axes.h"

namespace foverig {

/// What one eye of the `reprojected` pipeline keeps from frame to frame, wherever its kernels run:
/// two generations of history and support images, the depth mesh and the coarse view. Allocated
/// once a resolution. `Array` is Buffer or the backend's own.
template <template <class> class Array>
class EyeImages {
  public:
    /// upload(array, view of a host's array) fills an array.
    template <class Upload>
    EyeImages(EffectMemory& effect_memory, const EffectPlan& plan,
              const ReprojectionSettings& settings, const EyeView& first_view, const Upload& upload)
        : grid{first_view.width_px, first_view.height_px},
          coarse_grid(support_grid(settings, first_view)),
          view(first_view),
          last_view(first_view) {
        const auto width = static_cast<std::size_t>(grid.width_px);
        const auto height = static_cast<std::size_t>(grid.height_px);
        const auto columns = static_cast<std::size_t>(coarse_grid.width_px);
        const auto rows = static_cast<std::size_t>(coarse_grid.height_px);
        const std::size_t pixels = width * height;
        const std::size_t cells = columns * rows;
        const bool light = plan.on(Effect::light_buffer);
        MemoryCount& memory = effect_memory.of(Effect::reprojection);
        MemoryCount& light_memory = effect_memory.of(Effect::light_buffer);
        support_column = {memory, width};
        support_row = {memory, height};
        coarse_column_ = {memory, width};
        coarse_row_ = {memory, height};
        coarse_column_from_px_ = {memory, columns + 1};
        coarse_row_from_px_ = {memory, rows + 1};
        source_x_px = {memory, columns + kBlockCells};
        source_y_px = {memory, rows};
        const auto fill = [&](const EyeAxis& axis, auto& support_of, auto& cell_of,
                              auto& cell_from_px, auto& source_px) {
            upload(support_of, view_of(axis.support_of));
            upload(cell_of, view_of(axis.cell_of));
            upload(cell_from_px, view_of(axis.cell_from_px));
            upload(source_px, view_of(axis.source_px));
        };
        fill({coarse_grid.width_px, grid.width_px}, support_column, coarse_column_,
             coarse_column_from_px_, source_x_px);
        fill({coarse_grid.height_px, grid.height_px}, support_row, coarse_row_, coarse_row_from_px_,
             source_y_px);
        for (Array<float>* vertices : {&vertex_x_px, &vertex_y_px, &vertex_inverse_depth})
            *vertices = {memory, cells + kBlockCells};  // the last vector reads past the end
        cell_facing = {memory, cells};
        for (std::size_t g = 0; g < 2; ++g) {
            colour_[g] = {g == 0 ? effect_memory.base() : memory, pixels};  // any pipeline has one
            info_[g] = {memory, pixels};
            light_[g] = {light_memory, light ? pixels : 0};
            support_colour_[g] = {memory, cells};
            support_light_[g] = {light_memory, light ? cells : 0};
            support_depth_m_[g] = {memory, cells};
        }
        coarse_values_ = {memory, 3 * cells};
        coarse_marked_ = {memory, cells};
    }

    bool fits(const EyeView& other) const {
        return grid.width_px == other.width_px && grid.height_px == other.height_px;
    }
    /// Makes the current generation and view the last ones.
    void turn(const EyeView& next) {
        current_ ^= 1;
        last_view = view;
        view = next;
    }

    HistoryImages current() { return history(current_); }
    HistoryImages last() { return history(current_ ^ 1); }
    SupportImages support() { return support_images(current_); }
    SupportImages last_support() { return support_images(current_ ^ 1); }
    View<const Half4> image() const { return colour_[static_cast<std::size_t>(current_)].view(); }
    View<const std::uint8_t> coarse_marks() const { return coarse_marked_.view(); }

    DepthMesh mesh() const {
        return {vertex_x_px.data(),   vertex_y_px.data(), vertex_inverse_depth.data(),
                source_x_px.data(),   source_y_px.data(), coarse_grid.width_px,
                coarse_grid.height_px};
    }
    CoarseView coarse() {
        const std::size_t cells = coarse_marked_.size();
        float* const p = coarse_values_.data();
        return {p,
                p + cells,
                p + 2 * cells,
                coarse_marked_.data(),
                coarse_grid.width_px,
                coarse_grid.height_px};
    }
    CoarseLookup resampled() const {
        return {has_history ? coarse_marked_.data() : nullptr,
                coarse_column_.data(),
                coarse_row_.data(),
                coarse_column_from_px_.data(),
                coarse_row_from_px_.data(),
                coarse_grid.width_px,
                coarse_grid.height_px};
    }
    SupportLookup support_lookup() {
        return {support(),
                static_cast<float>(coarse_grid.width_px - 1) /
                    static_cast<float>(std::max(1, grid.width_px - 1)),
                static_cast<float>(coarse_grid.height_px - 1) /
                    static_cast<float>(std::max(1, grid.height_px - 1))};
    }

    /// The mesh of the last frame under the present view, and how squarely that frame saw it.
    ReprojectVertices reproject_vertices() {
        return {Reprojection(last_view, view),
                last_support().depth_m,
                source_x_px.data(),
                source_y_px.data(),
                coarse_grid.width_px,
                vertex_x_px.data(),
                vertex_y_px.data(),
                vertex_inverse_depth.data()};
    }
    MeasureFacing measure_facing() {
        return {
            last_support().depth_m,
            source_x_px.data(),
            source_y_px.data(),
            {(last_view.tan_left + last_view.tan_right) / static_cast<float>(last_view.width_px),
             (last_view.tan_up + last_view.tan_down) / static_cast<float>(last_view.height_px)},
            {-last_view.tan_left, -last_view.tan_up},
            coarse_grid.width_px,
            cell_facing.data()};
    }
    /// Of the coarse view's first tile.
    ResolveCoarse resolve_coarse(const RasterTile& raster) {
        const SupportLookup lookup = support_lookup();
        return {raster,
                coarse(),
                last().colour,
                grid.width_px,
                grid.height_px,
                cell_facing.data(),
                coarse_grid.width_px,
                coarse_grid.height_px,
                lookup.columns_per_px,
                lookup.rows_per_px,
                0,
                0,
                0};
    }
    MarkResampling mark_resampling(const ReprojectionSettings& s) {
        return {coarse(), static_cast<float>(s.epsilon_depth), static_cast<float>(s.epsilon_lum),
                static_cast<float>(s.epsilon_grazing)};
    }
    /// The mesh drawn at the support resolution, and at the image's.
    RasterFrame coarse_raster() const {
        RasterFrame frame;
        frame.mesh = mesh();
        frame.scale_x =
            static_cast<float>(coarse_grid.width_px) / static_cast<float>(grid.width_px);
        frame.scale_y =
            static_cast<float>(coarse_grid.height_px) / static_cast<float>(grid.height_px);
        return frame;
    }
    RasterFrame image_raster() const {
        RasterFrame frame;
        frame.mesh = mesh();
        return frame;
    }

    TileGrid grid;
    TileGrid coarse_grid;  ///< the support resolution
    EyeView view;          ///< of the current frame
    EyeView last_view;
    bool has_history = false;
    Array<std::int16_t> support_column;  ///< by pixel column: the support column there, or -1
    Array<std::int16_t> support_row;
    Array<float> source_x_px;  ///< image position of each mesh column
    Array<float> source_y_px;
    Array<float> vertex_x_px;
    Array<float> vertex_y_px;
    Array<float> vertex_inverse_depth;
    Array<float> cell_facing;  ///< see MeasureFacing

  private:
    HistoryImages history(int generation) {
        const auto g = static_cast<std::size_t>(generation);
        return {colour_[g].data(), info_[g].data(), light_[g].data()};
    }
    SupportImages support_images(int generation) {
        const auto g = static_cast<std::size_t>(generation);
        return {support_colour_[g].data(), support_light_[g].data(), support_depth_m_[g].data(),
                coarse_grid.width_px, coarse_grid.height_px};
    }

    int current_ = 0;
    Array<std::int16_t> coarse_column_;  ///< by pixel column: the coarse cell over it
    Array<std::int16_t> coarse_row_;
    Array<std::int16_t> coarse_column_from_px_;  ///< by cell column: its first pixel, and the end
    Array<std::int16_t> coarse_row_from_px_;
    std::array<Array<Half4>, 2> colour_;
    std::array<Array<CacheInfo>, 2> info_;
    std::array<Array<Half4>, 2> light_;
    std::array<Array<Half4>, 2> support_colour_;
    std::array<Array<Half4>, 2> support_light_;
    std::array<Array<float>, 2> support_depth_m_;
    Array<float> coarse_values_;
    Array<std::uint8_t> coarse_marked_;
};

}  // namespace foverig
