function handle = whirl_plot_map(result, varargin)
% WHIRL_PLOT_MAP  Draws the regimes of a map over its two parameters, or the numbers of a field.
%   WHIRL_PLOT_MAP(RESULT) draws cells in the colours of their regimes, paler where confidence is low; for a basin in
%   the colours of the attractors to which its starts lead. Refined maps are filled from the corners of their squares.
%   If points have several starts, a cell shows the motion to which most starts lead. Cells without a point stay empty.
%   WHIRL_PLOT_MAP(RESULT, PLANE) draws a plane of a map over three parameters, from 1 (default: the first). Of more
%   than twelve planes, only those of the figure can be drawn. WHIRL_PLOT_MAP(RESULT, PLANE, FIELD, OF) draws the
%   numbers of a field ('orbit/max_radius', 'lyapunov/largest') with a colour scale; OF is the station or the contact to
%   which the numbers belong (name or number; default: the first). WHIRL_PLOT_MAP(..., 'column', COLUMN) draws a column
%   of the field (name or number), not the first. WHIRL_PLOT_MAP(..., 'table', NAME) draws the table NAME ('map' or
%   'basin'), not the first with two parameters.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_READ, WHIRL_PLOT_SHARES.
FIELD = field_names();
[places, options] = arguments_of(varargin, {1, [], []}, struct('column', 1, 'table', []));
result = result_of(result);
[table, name] = map_of(result, options.table);
panel = panel_of(table, places{1});
if ~isempty(places{2})
    figure_of = field_figure(result, table, places{2}, places{3}, options.column);
elseif strcmp(table.attributes.role, 'basin')
    figure_of = 'basins';
else
    table_with(result, FIELD.regime_code, 'regime', name);
    figure_of = 'map-regime';
end
handle = draw_panel_of(result, [name '/' figure_of], panel);
end

function [table, name] = map_of(result, wanted)
% Returns the table of a name, or the first table with two parameters.
FIELD = field_names();
name = text_of(wanted);
if isempty(wanted)
    name = first_with(result, FIELD.map_second, true);
end
if ~any(strcmp(name, result.attributes.tables)) || ~has_field(result.(name), FIELD.map_second)
    error('whirl:badInput', 'the result has no such map: ''study: {map: {x: ..., y: ...}}'' in a case computes one');
end
table = result.(name);
end

function panel = panel_of(table, plane)
% Returns the panel of a plane. A map over two parameters has one plane; figures show at most twelve planes, evenly
% chosen.
count = 1;
if isfield(table, 'z')
    count = numel(table.z);
end
most = min(count, 12);
shown = 1 + floor((0:most - 1) * (count - 1) / max(1, most - 1));
if ~isnumeric(plane) || numel(plane) ~= 1 || ~any(plane == shown)
    error('whirl:badInput', 'there is no such plane, expected one of: %s', strtrim(sprintf('%d ', shown)));
end
panel = 'map';
if count > 1
    panel = sprintf('plane-%d', find(plane == shown));
end
end

function name = field_figure(result, table, field, of, column)
% Returns the name of the figure of a field, 'orbit/mean:disc:y'.
if ~is_text(field) || ~has_field(table, field)
    error('whirl:badInput', 'the map has no such field, its attributes.fields lists those that it has');
end
[ignored, about] = field_of(table, field); %#ok<ASGLU>
name = field;
if strcmp(about.extent, 'station')
    name = [name ':' result.stations.name{station_index(result, of)}];
elseif strcmp(about.extent, 'contact')
    name = [name ':' result.contacts.name{index_of_name(result.contacts.name, of, 'contact')}];
end
if about.columns > 1
    name = [name ':' about.column_names{coordinate_index(text_of(column), about.column_names)}];
end
end
