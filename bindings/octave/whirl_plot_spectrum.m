function handle = whirl_plot_spectrum(result, varargin)
% WHIRL_PLOT_SPECTRUM  Draws the strongest lines of the spectrum of a station at a point of a study.
%   WHIRL_PLOT_SPECTRUM(RESULT, POINT, STATION) draws the full spectrum over orders, multiples of the speed: forward
%   whirl above 0, backward whirl below. POINT counts from 1, STATION is a name or a number.
%   WHIRL_PLOT_SPECTRUM(..., 'full', false) draws the spectrum of x alone.
%   WHIRL_PLOT_SPECTRUM(RESULT, [], STATION, 'at', VALUE) draws the point whose parameter is nearest to a value in SI,
%   or to a text with the unit of the figure: '600 rpm'.
%   WHIRL_PLOT_SPECTRUM(..., 'table', NAME) draws that table, and not the first with spectra.
%
%   Gives the handle of the lines, or those of the forward and of the backward ones; NaN parts the lines.
%
%   See also WHIRL_PLOT_WATERFALL, WHIRL_PLOT_ORBIT.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('full', true, 'at', [], 'table', []));
subject = subject_of(result, FIELD.spectrum_lines, 'spectrum', options.table, places{2});
point = point_index(subject, places{1}, options.at);
lines_of = field_of(subject.table, FIELD.spectrum_lines);
lines_of = reshape(lines_of(point, subject.index, :, :), size(lines_of, 3), []);
lines_of = lines_of(~isnan(lines_of(:, 1)), :);
order = lines_of(:, 1);
amplitude = lines_of(:, 2:5) * subject.lengths(point) * subject.result.case_.attributes.shown_amplitude;
floor_of = zeros(size(order));
[axes_handle, held] = begin_figure();
last = 1.05 * max([1; order]);
if is_full(options.full)
    amplitude = amplitude(:, 3:4);
    zero = guide_line(axes_handle, [0, 0], [0, 1], '-');
    handle = [vertical_lines(axes_handle, order, floor_of, amplitude(:, 1), [0, 0, 0], 1.5); ...
        vertical_lines(axes_handle, -order, floor_of, amplitude(:, 2), [0, 0, 0], 1.5)];
    from_zero(axes_handle, amplitude);
    set(zero, 'YData', get(axes_handle, 'YLim'));
    set(axes_handle, 'XLim', [-last, last]);
else
    handle = vertical_lines(axes_handle, order, floor_of, amplitude(:, 1), [0, 0, 0], 1.5);
    from_zero(axes_handle, amplitude(:, 1));
    set(axes_handle, 'XLim', [0, last]);
end
end_figure(axes_handle, held, order_label(options.full), ...
    amplitude_label(subject), point_title(subject, point));
end
