function handle = whirl_plot_branches(result, varargin)
% WHIRL_PLOT_BRANCHES  Draws branches of periodic orbits: stable parts as lines, unstable ones dashed.
%   WHIRL_PLOT_BRANCHES(RESULT, STATION, COORDINATE) draws the largest 'x' or 'y' (or 1, 2) of a station along an orbit
%   over the parameter, each branch in a colour of its own. Marks tell what special points are (folds, crossings of
%   branches, period doublings, Neimark-Sacker and Hopf points, grazing), with their values beside them.
%   WHIRL_PLOT_BRANCHES(..., 'table', NAME) draws that table, and not the first with branches.
%
%   Gives the handles of the lines, then of the marks of every kind that is there, in the order above.
%
%   See also WHIRL_PLOT_BIFURCATION.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], 1}, struct('table', []));
subject = subject_of(result, FIELD.trace_high, 'branch', options.table, places{1});
column = coordinate_index(places{2}, {'x', 'y'});
high = field_of(subject.table, FIELD.trace_high);
y = high(:, subject.index, 1, column) .* subject.lengths;
number = field_of(subject.table, FIELD.trace_number);
stable = field_of(subject.table, FIELD.trace_unstable) == 0;
[axes_handle, held] = begin_figure();
handle = [];
for branch = unique(number)'
    handle = [handle; draw_branch(axes_handle, subject.values, y, find(number == branch), stable, ...
        branch_colour(branch))]; %#ok<AGROW>
end
pad_values(axes_handle, subject.values);
[marks, names] = draw_special(axes_handle, field_of(subject.table, FIELD.trace_special), subject.values, y);
handle = [handle; marks];
key = [plot(axes_handle, NaN, NaN, 'k-', 'LineWidth', 1.25); plot(axes_handle, NaN, NaN, 'k--', 'LineWidth', 1.25)];
place_legend(axes_handle, [key; marks], [{'stable', 'unstable'}, names], subject.values, y);
end_figure(axes_handle, held, subject.label, ...
    length_label(subject.result, ['largest ' char('w' + column) ' of ' subject.station]));
end

function handle = draw_branch(axes_handle, x, y, own, stable, rgb)
% The pieces of a branch whose points are OWN, each up to the point where stability has changed.
first = [1; 1 + find(diff(double(stable(own))) ~= 0)];
last = [first(2:end); numel(own)];
handle = [];
for i = 1:numel(first)
    piece = own(first(i):last(i));
    style = '--';
    if stable(piece(1))
        style = '-';
    end
    handle = [handle; plot(axes_handle, x(piece), y(piece), style, 'Color', rgb, 'LineWidth', 1.25)]; %#ok<AGROW>
end
end

function rgb = branch_colour(number)
% Those of reports, over and over.
colours = {'#1F77B4', '#FF7F0E', '#2CA02C', '#D62728', '#9467BD', '#8C564B', '#E377C2', '#7F7F7F', ...
    '#BCBD22', '#17BECF'};
rgb = colour(colours{mod(number - 1, numel(colours)) + 1});
end

function [handle, names] = draw_special(axes_handle, special, x, y)
% Marks of special points by their kinds.
titles = {'fold', 'crossing', 'period doubling', 'Neimark-Sacker', 'Hopf', 'grazing'};
markers = {'s', 'd', '^', 'o', 'v', 'x'};
handle = [];
names = {};
for kind = 1:numel(titles)
    of = find(special == kind);
    if ~isempty(of)
        mark = draw_marks(axes_handle, x(of), y(of), markers{kind}, 7, [0, 0, 0], false);
        handle = [handle; mark]; %#ok<AGROW>
        names = [names, titles(kind)]; %#ok<AGROW>
    end
end
value_labels(axes_handle, x(special > 0), y(special > 0), '%.6g');
end
