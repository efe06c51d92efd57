function handle = whirl_plot_campbell(result, varargin)
% WHIRL_PLOT_CAMPBELL  Draws the Campbell diagram of a result with modes: natural frequencies over the parameter.
%   WHIRL_PLOT_CAMPBELL(RESULT) draws the damped frequencies in the unit of the speed, in Hz where something else than
%   the speed varies: forward whirl blue and upwards, backward vermilion and downwards, neither grey and round. The
%   dashed line is once a revolution (1X). Circles are critical speeds, crosses thresholds of stability, with their
%   values. Frequencies above twice the highest speed are cut off.
%   WHIRL_PLOT_CAMPBELL(RESULT, 'table', NAME) draws that table, and not the first with modes.
%
%   Gives the handles of all that is there, in the order of the legend.
%
%   See also WHIRL_PLOT_BODE.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
subject = subject_of(result, FIELD.modes_frequency, 'modes', options.table, []);
[unit, size_in_si] = frequency_unit(subject);
speed = field_of(subject.table, FIELD.modes_speed) / size_in_si;
frequency = field_of(subject.table, FIELD.modes_frequency);
frequency = reshape(frequency, size(frequency, 1), []) / size_in_si;
direction = reshape(field_of(subject.table, FIELD.modes_direction), size(frequency));
[axes_handle, held] = begin_figure();
once = plot(axes_handle, subject.values, speed, '--', 'Color', [0.4, 0.4, 0.4], 'LineWidth', 1);
[handle, names] = draw_modes(axes_handle, repmat(subject.values, 1, size(frequency, 2)), frequency, direction);
handle = [handle; once];
names = [names, {'1X'}];
cut_off(axes_handle, frequency, speed);
[marks, words] = draw_critical(axes_handle, subject, size_in_si);
handle = [handle; marks];
names = [names, words];
% The line hides nothing if the legend knows more of it than its ends.
x = [repmat(subject.values, size(frequency, 2), 1); linspace(subject.values(1), subject.values(end), 50)'];
place_legend(axes_handle, handle, names, x, [frequency(:); linspace(speed(1), speed(end), 50)']);
end_figure(axes_handle, held, subject.label, ['damped frequency (' unit ')']);
end

function [unit, size_in_si] = frequency_unit(subject)
% The unit of the parameter where it is the speed of the shaft, else Hz; and its size.
FIELD = field_names();
speed = field_of(subject.table, FIELD.modes_speed);
values = flat(subject.table, subject.table.values);
unit = 'Hz';
size_in_si = 2 * pi;
if all(abs(speed - values) <= 1e-9 * abs(values))
    [size_in_si, unit] = parameter_unit(subject.result, subject.table.attributes.parameter);
    if isempty(unit)
        unit = 'rad/s';
    end
end
end

function [handle, names] = draw_modes(axes_handle, x, frequency, direction)
% Marks of the modes that whirl forward, backward, and neither way.
titles = {'forward', 'backward', 'neither'};
markers = {'^', 'v', 'o'};
colours = colour({'#0072B2', '#D55E00', '#606060'});
ways = {direction > 0.05, direction < -0.05, abs(direction) <= 0.05};
handle = [];
names = {};
for i = 1:3
    there = ways{i} & ~isnan(frequency);
    if any(there(:))
        handle = [handle; draw_marks(axes_handle, x(there), frequency(there), markers{i}, 0.5 + mark_size(numel(x)), ...
            colours(i, :))]; %#ok<AGROW>
        names = [names, titles(i)]; %#ok<AGROW>
    end
end
end

function cut_off(axes_handle, frequency, speed)
% Modes far above all speeds would press the others together.
top = max(frequency(~isnan(frequency)));
if max(speed) > 0
    top = min([1.05 * top, 2 * max(speed)]);
end
if top > 0
    set(axes_handle, 'YLim', [0, top]);
end
end

function [handle, names] = draw_critical(axes_handle, subject, size_in_si)
% Marks of critical speeds and thresholds of stability.
FIELD = field_names();
rows = field_of(subject.table, FIELD.modes_critical);
rows = reshape(rows, [], size(rows, 4));
rows = rows(~isnan(rows(:, 2)) & rows(:, 1) > 0, :);
own = parameter_unit(subject.result, subject.table.attributes.parameter);
titles = {'critical speed', 'threshold of stability'};
of = {rows(rows(:, 1) == 1, :), rows(rows(:, 1) > 1, :)};
handle = [];
names = {};
for i = 1:2
    if ~isempty(of{i})
        x = of{i}(:, 2) / own;
        y = of{i}(:, 4) / size_in_si;
        if i == 1
            mark = draw_marks(axes_handle, x, y, 'o', 8, [0, 0, 0], false);
        else
            mark = draw_marks(axes_handle, x, y, 'x', 9, [0.8, 0, 0]);
        end
        set(mark, 'LineWidth', 1.25);
        handle = [handle; mark]; %#ok<AGROW>
        names = [names, titles(i)]; %#ok<AGROW>
    end
end
value_labels(axes_handle, rows(:, 2) / own, rows(:, 4) / size_in_si, '%.5g');
end
