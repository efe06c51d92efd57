function handle = whirl_plot_branches(result, varargin)
% WHIRL_PLOT_BRANCHES  Draws branches of periodic orbits: stable parts as lines, unstable ones dashed.
%   WHIRL_PLOT_BRANCHES(RESULT, STATION, COORDINATE) draws 'x' or 'y' (or 1, 2) of a station once a revolution over the
%   parameter. Marks show the kinds of special points (folds, crossings of branches, period doublings, Neimark-Sacker
%   and Hopf points, grazing).
%   WHIRL_PLOT_BRANCHES(..., 'table', NAME) draws the table NAME, not the first with branches.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_BIFURCATION.
FIELD = field_names();
names = {'x', 'y'};
[places, options] = arguments_of(varargin, {[], 1}, struct('table', []));
result = result_of(result);
panel = names{coordinate_index(places{2}, names)};
handle = draw_panel_of(result, figure_name(result, 'branch', FIELD.trace_high, options.table, places{1}), panel);
end
