function index = station_index(result, station)
% STATION_INDEX  The number of a station: by its name, by its number, or [] for the first.
if isempty(station)
    index = 1;
elseif ischar(station)
    index = find(strcmp(result.stations.name, station));
else
    index = station;
end
count = numel(result.stations.name);
if numel(index) ~= 1 || index < 1 || index > count || index ~= floor(index)
    error('whirl:badInput', 'there is no such station, expected a number up to %d or one of: %s', count, ...
        strtrim(sprintf('%s ', result.stations.name{:})));
end
end
