function handle = whirl_plot_map(result, varargin)
% WHIRL_PLOT_MAP  Draws the regimes of a map over its two parameters, or the numbers of a field.
%   WHIRL_PLOT_MAP(RESULT) draws cells in the colours of their regimes, paler where confidence is low; of a basin the
%   attractors that its starts lead to. Refined maps are filled from the corners of their squares. Where points have
%   several starts, cells show what most of them lead to. Cells without a point stay empty.
%   WHIRL_PLOT_MAP(RESULT, PLANE) draws that plane of a map over three parameters, from 1; the first one without it.
%   WHIRL_PLOT_MAP(RESULT, PLANE, FIELD, OF) draws the numbers of a field ('orbit/max_radius', 'lyapunov/largest') with
%   a colour bar; OF is the station or the contact whose numbers these are (name or number), the first without it.
%   WHIRL_PLOT_MAP(..., 'column', COLUMN) takes that column of the field (name or number), and not the first.
%   WHIRL_PLOT_MAP(..., 'table', NAME) draws that table ('map' or 'basin'), and not the first of them.
%
%   Gives the handle of a patch; its FaceVertexCData are colours or numbers of the cells.
%
%   See also WHIRL_READ, WHIRL_PLOT_SHARES.
FIELD = field_names();
[places, options] = arguments_of(varargin, {1, [], []}, struct('column', 1, 'table', []));
result = result_of(result);
[table, name] = map_of(result, options.table);
cover = cover_of(table, name, checked_plane(table, places{1}));
x = axis_values(flat(table, table.values), cover, 2) / parameter_unit(result, table.attributes.parameter);
y = axis_values(field_of(table, FIELD.map_second), cover, 1) / parameter_unit(result, table.attributes.second);
if isempty(places{2})
    kinds = kinds_of(table, name, strcmp(name, 'basin'));
    if isempty(kinds)
        error('whirl:badInput', 'the table ''%s'' has no verdicts: add regime to what the case analyses', name);
    end
else
    [numbers, label] = numbers_of(result, table, places{2}, places{3}, options.column);
end
[axes_handle, held] = begin_figure();
if isempty(places{2})
    handle = draw_cells(axes_handle, x, y, cover, kind_colours(kinds));
    kinds_legend(axes_handle, kinds_there(kinds, cover), 's');
else
    handle = draw_cells(axes_handle, x, y, cover, numbers);
    colour_bar(axes_handle, label, sequential_colours());
end
end_figure(axes_handle, held, parameter_label(result, table.attributes.parameter), ...
    parameter_label(result, table.attributes.second), plane_title(result, table, cover));
end

function [table, name] = map_of(result, wanted)
% The table of that name, or the first, that has two parameters.
FIELD = field_names();
for i = 1:numel(result.attributes.tables)
    name = result.attributes.tables{i};
    table = result.(name);
    if has_field(table, FIELD.map_second) && (isempty(wanted) || strcmp(name, text_of(wanted)))
        return
    end
end
error('whirl:badInput', 'the result has no such map: ''study: {map: {x: ..., y: ...}}'' in a case computes one');
end

function plane = checked_plane(table, plane)
count = plane_count(table);
if ~isnumeric(plane) || numel(plane) ~= 1 || ~any(plane == 1:count)
    error('whirl:badInput', 'there is no such plane, expected a number from 1 to %d', count);
end
end

function colours = kind_colours(kinds)
% The colour of every point, mixed with white where it is pale.
[ignored, rank] = ismember(kinds.of, kinds.number); %#ok<ASGLU>
paleness = repmat(kinds.paleness, 1, 3);
colours = kinds.colours(rank, :) .* (1 - paleness) + paleness;
end

function kinds = kinds_there(kinds, cover)
% Those kinds that the plane shows.
kept = ismember(kinds.number, kinds.of(cover(cover > 0)));
kinds.number = kinds.number(kept);
kinds.colours = kinds.colours(kept, :);
kinds.names = kinds.names(kept);
end

function [numbers, label] = numbers_of(result, table, field, of, column)
% The numbers of a field at every point, and what they are called.
if ~is_text(field) || ~has_field(table, field)
    error('whirl:badInput', 'the map has no such field, its attributes.fields lists those that it has');
end
[numbers, about] = field_of(table, field);
owner = '';
index = 1;
if strcmp(about.extent, 'station')
    index = station_index(result, of);
    owner = [' of ' result.stations.name{index}];
elseif strcmp(about.extent, 'contact')
    index = index_of_name(result.contacts.name, of, 'contact');
    owner = [' of ' result.contacts.name{index}];
end
if about.rows > 1
    error('whirl:badInput', 'the field has several rows a point: %s', field);
end
column = column_index(about, column);
numbers = numbers(:, index, 1, column);
% What stands in brackets behind the meaning is for tables.
what = regexprep(about.meaning, ' \(.*$', '');
if about.columns > 1 && isfield(about, 'column_names')
    % The meaning of these lists the columns.
    what = [field ' ' about.column_names{column}];
end
what = [what owner];
if strcmp(about.unit, 'length')
    [counted, factor] = counting_of(result, about.meaning);
    numbers = numbers .* length_factors(result, table) * factor;
    label = length_label(result, what, counted);
elseif strcmp(about.unit, '1')
    label = what;
elseif isnan(about.SI_factor) || strcmp(about.SI_unit, '1')
    label = [what ' (' about.unit ')'];
else
    numbers = numbers * about.SI_factor;
    label = [what ' (' about.SI_unit ')'];
end
end

function index = column_index(about, column)
names = arrayfun(@(i) sprintf('%d', i), 1:about.columns, 'UniformOutput', false);
if isfield(about, 'column_names')
    names = about.column_names;
end
index = coordinate_index(text_of(column), names);
end

function heading = plane_title(result, table, cover)
% Of a map over three parameters the third one's value.
FIELD = field_names();
heading = '';
there = cover(find(cover > 0, 1));
if isfield(table.attributes, 'third') && ~isempty(table.attributes.third) && ~isempty(there)
    third = field_of(table, FIELD.map_third);
    heading = value_text(result, table.attributes.third, third(there));
end
end
