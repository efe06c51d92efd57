function handle = whirl_plot_bode(result, varargin)
% WHIRL_PLOT_BODE  Draws the response to unbalance: amplitude along x and y over the parameter, and its lag below.
%   WHIRL_PLOT_BODE(RESULT, STATION) draws that of a station (name or number), of the first one without it, into two
%   axes of the current figure. The line of the lag is broken where it jumps by more than 180 degrees.
%   WHIRL_PLOT_BODE(..., 'table', NAME) draws that table, and not the first with a response to unbalance.
%
%   Gives the handles of the lines along x and y: of the amplitude in the first row, of the lag in the second.
%
%   See also WHIRL_PLOT_CAMPBELL.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[]}, struct('table', []));
subject = subject_of(result, FIELD.unbalance_amplitude, 'unbalance', options.table, places{1});
amplitude = subject.lengths * subject.result.case_.attributes.shown_amplitude;
amplitude = [amplitude, amplitude] .* both_ways(subject, FIELD.unbalance_amplitude);
above = subplot(2, 1, 1);
set(above, 'Position', [0.16, 0.58, 0.8, 0.37]);
rows = draw_both(subject.values, amplitude, false);
from_zero(above, amplitude);
place_legend(above, rows', {'x', 'y'}, [subject.values; subject.values], amplitude);
end_figure(above, false, '', amplitude_label(subject));
below = subplot(2, 1, 2);
set(below, 'Position', [0.16, 0.15, 0.8, 0.34]);
lag = both_ways(subject, FIELD.unbalance_lag);
rows = [rows; draw_both(subject.values, lag, true)];
degree_ticks(below);
end_figure(below, false, subject.label, 'lag (degrees)');
% Half of a figure is short for what stands there.
set([get(above, 'YLabel'), get(below, 'YLabel')], 'FontSize', 8);
handle = rows;
end

function numbers = both_ways(subject, field)
% What a field says along x and y of the station: [points][2].
numbers = field_of(subject.table, field);
numbers = reshape(numbers(:, subject.index, 1, :), [], 2);
end

function row = draw_both(x, numbers, breaks)
% A line along x and one along y.
colours = colour({'#0072B2', '#D55E00'});
axes_handle = begin_figure();
row = [];
for along = 1:2
    at = x;
    y = numbers(:, along);
    if breaks
        [at, y] = broken(x, y);
    end
    row = [row, plot(axes_handle, at, y, '-', 'Color', colours(along, :), 'LineWidth', 1.25)]; %#ok<AGROW>
end
end

function [x, y] = broken(x, y)
% A line with a gap where an angle jumps by more than half a turn.
for i = fliplr(find(abs(diff(y)) > 180)')
    x = [x(1:i); x(i); x(i + 1:end)];
    y = [y(1:i); NaN; y(i + 1:end)];
end
end

function degree_ticks(axes_handle)
% Ticks at angles that one knows.
limits = get(axes_handle, 'YLim');
steps = [1, 2, 5, 15, 30, 45, 90, 180, 360];
step = steps(find([steps(1:end - 1), Inf] >= diff(limits) / 7, 1));
ticks = 0 + step * (ceil(limits(1) / step - 1e-9):floor(limits(2) / step + 1e-9));
set(axes_handle, 'YLim', limits, 'YTick', ticks);
end
