function mark = file_mark(file)
% FILE_MARK  Returns date and size of a file, by which changes are detected; [] if there is no file.
found = dir(file);
mark = [];
if numel(found) == 1
    mark = [found.datenum, found.bytes];
end
end
