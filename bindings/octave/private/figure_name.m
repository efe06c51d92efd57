function name = figure_name(result, kind, field, table, station)
% FIGURE_NAME  Returns the name of a figure of a KIND: of the table TABLE or, if it is empty, the first with FIELD, and
% of a station (name or number, [] for the first) if figures of the kind have one.
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
