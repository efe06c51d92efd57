function handle = whirl_plot_bifurcation(result, varargin)
% WHIRL_PLOT_BIFURCATION  Draws a bifurcation diagram: sections over the parameter, in the colours of their regimes.
%   WHIRL_PLOT_BIFURCATION(RESULT) draws x of the first station once per revolution. RESULT is a struct of WHIRL_READ or
%   the name of a file. Where points have several starts, every attractor is drawn once, in a colour of its own.
%   WHIRL_PLOT_BIFURCATION(RESULT, STATION, COORDINATE) draws that of a station (name or number); COORDINATE is 'x',
%   'y', 'vx', 'vy' (velocities, per radian of rotation), or its number.
%   WHIRL_PLOT_BIFURCATION(..., 'table', NAME) draws that table, and not the first with sections.
%
%   Gives a handle for every regime or attractor, in the order of the legend.
%
%   See also WHIRL_READ, WHIRL_PLOT_POINCARE, WHIRL_PLOT_LYAPUNOV, WHIRL_PLOT_SHARES.
FIELD = field_names();
names = {'x', 'y', 'vx', 'vy'};
[places, options] = arguments_of(varargin, {[], 1}, struct('table', []));
subject = subject_of(result, FIELD.poincare_section, 'poincare', options.table, places{1});
column = coordinate_index(places{2}, names);
section = field_of(subject.table, FIELD.poincare_section);
count = size(section, 3);
section = reshape(section(:, subject.index, :, column), [], count) .* repmat(subject.lengths, 1, count);
parameter = repmat(subject.values, 1, count);
once = points_once(subject.table, subject.name);
kinds = kinds_of(subject.table, subject.name, has_attractors(subject.table, subject.name));
[axes_handle, held] = begin_figure();
points = mark_size(numel(once) * count);
handle = [];
pad_values(axes_handle, subject.values);
if isempty(kinds)
    handle = draw_marks(axes_handle, parameter(once, :), section(once, :), 'o', points, [0, 0, 0]);
else
    for i = 1:numel(kinds.number)
        own = once(kinds.of(once) == kinds.number(i));
        handle = [handle; draw_marks(axes_handle, parameter(own, :), section(own, :), 'o', points, ...
            kinds.colours(i, :))]; %#ok<AGROW>
    end
    kinds_legend(axes_handle, kinds, 'o', parameter(once, :), section(once, :));
end
label = length_label(subject.result, [names{column} ' of ' subject.station]);
if column > 2
    label = [label ' per radian'];
end
end_figure(axes_handle, held, subject.label, label);
end
