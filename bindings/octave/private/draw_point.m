function handle = draw_point(result, places, options, field, analysis, panel)
% DRAW_POINT  Draws a panel of the figure of a point. PLACES are a point and a station, OPTIONS are 'at' and 'table', as
% in WHIRL_PLOT_ORBIT. Without 'table' it takes the first table with FIELD; the message without such a table names
% ANALYSIS, which computes the field.
result = result_of(result);
[table, name] = table_with(result, field, analysis, options.table, ~strcmp(panel, 'section'));
point = point_index(table, places{1}, options.at);
station = result.stations.name{station_index(result, places{2})};
handle = draw_panel_of(result, sprintf('%s/@%s:%s', name, point, station), panel, true);
end
