function name = figure_name(result, kind, table, station)
% FIGURE_NAME  The name of a figure of a station (name or number, [] for the first), of a table where one is named.
name = kind;
if nargin > 3
    name = [kind '-' result.stations.name{station_index(result, station)}];
end
if ~isempty(table)
    table_with(result, '', '', table, true);
    name = [text_of(table) '/' name];
end
end
