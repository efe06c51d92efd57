function name = figure_name(result, kind, field, table, station)
% FIGURE_NAME  The name of a figure: of the table that is named, or the first with a FIELD, and of a station (name or
%   number, [] for the first) where figures of the KIND have one.
name = kind;
if nargin > 4
    name = [kind '-' result.stations.name{station_index(result, station)}];
end
own = first_with(result, field, true);
if ~isempty(table)
    [ignored, own] = table_with(result, '', '', table); %#ok<ASGLU>
end
if ~isempty(own)
    name = [own '/' name];
end
end
