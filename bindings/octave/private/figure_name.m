function name = figure_name(result, kind, field, table, station)
% FIGURE_NAME  The name of a figure: of the table that is named, or the first with a FIELD, and of a station (name or
%   number, [] for the first) where figures of the KIND have one.
name = kind;
if nargin > 4
    name = [kind '-' result.stations.name{station_index(result, station)}];
end
if ~isempty(table)
    table_with(result, '', '', table);
    name = [text_of(table) '/' name];
    return
end
for i = 1:numel(result.attributes.tables)
    own = result.attributes.tables{i};
    if has_field(result.(own), field)
        name = [own '/' name];
        return
    end
end
end
